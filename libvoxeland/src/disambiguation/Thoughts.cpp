// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/disambiguation/Thoughts.h"

#include "voxeland/base/lowerCase.h"
#include "voxeland/base/trimmed.h"

#include <algorithm>
#include <cctype>

namespace voxeland
{
namespace
{
/** In lower case; they are found in any. */
constexpr const char* MARKS[][2] = {
    {"<think>", "</think>"},
    {"<thinking>", "</thinking>"},
    {"<thought>", "</thought>"},
    {"<thoughts>", "</thoughts>"},
    {"<reasoning>", "</reasoning>"},
    {"<reflection>", "</reflection>"},
    {"<scratchpad>", "</scratchpad>"},
    {"<seed:think>", "</seed:think>"},
    {"[think]", "[/think]"},
    {"\u25c1think\u25b7", "\u25c1/think\u25b7"},
    {"<|begin_of_thought|>", "<|end_of_thought|>"},
    {"<|start_thinking|>", "<|end_thinking|>"},
    {"<|channel>thought", "<channel|>"},
    {"<|channel|>analysis", "<|channel|>final<|message|>"},
    {"<|channel|>analysis", "assistantfinal"},
};

/** Erases what stands between the marks, and a beginning that has only an end. */
std::string withoutThoughts(const std::string& text, const std::string& begin,
                            const std::string& end)
{
    const std::string searched = lowerCase(text);
    std::string rest;
    size_t at = 0, from = searched.find(begin);
    for (size_t to = searched.find(end); to != std::string::npos; to = searched.find(end, at)) {
        if (from < at) from = searched.find(begin, at);
        if (from < to)
            rest.append(text, at, from - at);
        else
            rest.clear();
        rest += '\n';
        at = to + end.size();
    }
    return rest.append(text, at);
}
}  // namespace

std::string withoutThoughts(const std::string& answer)
{
    std::string text = answer;
    for (const auto& [begin, end] : MARKS) text = withoutThoughts(text, begin, end);
    for (const auto& [begin, end] : MARKS)
        text.resize(std::min(text.size(), lowerCase(text).find(begin)));
    return trimmed(text);
}
}  // namespace voxeland
