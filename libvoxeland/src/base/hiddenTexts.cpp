// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/base/hiddenTexts.h"

#include "voxeland/base/lowerCase.h"

#include <map>
#include <mutex>
#include <shared_mutex>

namespace voxeland
{
namespace
{
struct LongestFirst
{
    bool operator()(const std::string& a, const std::string& b) const
    {
        return a.size() != b.size() ? a.size() > b.size() : a < b;
    }
};

struct Hidden
{
    std::shared_mutex mutex;
    std::map<std::string, std::string, LongestFirst> shownAs;  //!< by text in small letters
};

Hidden& hidden()
{
    static Hidden all;
    return all;
}

/** Whether a place is within what is shown instead: a variable may hold its own name. */
bool isShown(std::string_view text, size_t at, const std::string& shownAs)
{
    const size_t begin = text.rfind(shownAs[0], at);
    return begin != std::string_view::npos && text.substr(begin, shownAs.size()) == shownAs &&
           at < begin + shownAs.size();
}
}  // namespace

void hideText(const std::string& text, const std::string& shownAs)
{
    constexpr size_t SHORTEST = 6;
    if (text.size() < SHORTEST) return;
    const std::unique_lock lock(hidden().mutex);
    hidden().shownAs.emplace(lowerCase(text), shownAs);
}

std::string withoutHidden(std::string_view text)
{
    std::string shown(text);
    const std::shared_lock lock(hidden().mutex);
    for (const auto& [secret, shownAs] : hidden().shownAs) {
        std::string small = lowerCase(shown);
        for (size_t at = small.find(secret); at != std::string::npos; at = small.find(secret, at)) {
            if (isShown(shown, at, shownAs)) {
                ++at;
                continue;
            }
            shown.replace(at, secret.size(), shownAs);
            small.replace(at, secret.size(), shownAs);
            at += shownAs.size();
        }
    }
    return shown;
}
}  // namespace voxeland
