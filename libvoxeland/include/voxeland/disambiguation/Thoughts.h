// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace voxeland
{
/** What is left of a model's answer without the thoughts before it, which some servers leave in:
 * `<think>...</think>`, `[THINK]...[/THINK]`, the channels of gpt-oss and Gemma and so on, also
 * where the mark at their beginning is missing. Empty if it only thought, or was cut off while it
 * did. */
std::string withoutThoughts(const std::string& answer);
}  // namespace voxeland
