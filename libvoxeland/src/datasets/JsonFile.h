// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>

#include <string>

namespace voxeland
{
/** Parses JSON.
 *  \param file where the text comes from, for the message
 *  \throws InputError, with line and column, if it is not valid */
nlohmann::json parseJson(const std::string& text, const std::string& file);

/** Reads and parses a JSON file. \throws InputError if it cannot be read, or as parseJson() */
nlohmann::json readJson(const std::string& file);
}  // namespace voxeland
