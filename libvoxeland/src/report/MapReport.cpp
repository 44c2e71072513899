// SPDX-License-Identifier: BSD-3-Clause
#include "MapReport.h"

#include "ReportData.h"
#include "ReportPage.h"

#include <utility>

namespace voxeland
{
namespace
{
std::string replaced(std::string text, const std::string& what, const std::string& by)
{
    for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
    return text;
}

/** Code for inside a script element, which nothing in it must end. */
std::string asScript(const std::string& code)
{
    return replaced(code, "</", "<\\/");
}

/** JSON for inside a script element. */
std::string asScriptData(const std::string& json)
{
    return replaced(json, "<", "\\u003c");
}

/** Text for between tags. */
std::string escaped(const std::string& text)
{
    return replaced(replaced(text, "&", "&amp;"), "<", "&lt;");
}
}  // namespace

std::string reportAsHtml(const SemanticVoxelMap& map, const MappingCounts& counts,
                         const ReportOptions& options, const ThreeLibrary& three)
{
    // Each part goes where its place is in the page; what it contains is not looked at again.
    const std::pair<std::string, std::string> parts[] = {
        {"{{title}}", escaped(options.title)},
        {"{{style}}", PAGE_CSS},
        {"{{three}}", asScript(three.core)},
        {"{{controls}}", asScript(three.orbitControls)},
        {"{{data}}", asScriptData(reportData(map, counts, options))},
        {"{{script}}", asScript(PAGE_JS)}};
    std::string page;
    std::string rest = PAGE_HTML;
    for (const auto& [place, content] : parts) {
        const size_t at = rest.find(place);
        page += rest.substr(0, at) + content;
        rest = rest.substr(at + place.size());
    }
    return page + rest;
}
}  // namespace voxeland
