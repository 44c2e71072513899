// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>

#include <string>

namespace voxeland
{
/** Parses JSON. NaN and Infinity, which Python writes and JSON lacks, are read as null.
 *  \param file where the text comes from, for the message
 *  \throws InputError, with line and column, if it is not valid */
nlohmann::json parseJson(const std::string& text, const std::string& file);

/** Reads and parses a JSON file. \throws InputError if it cannot be read, or as parseJson() */
nlohmann::json readJson(const std::string& file);

/** The same; objects in lines of their own (JSON Lines) are read as a list of them. */
nlohmann::json readJsonOrLines(const std::string& file);
}  // namespace voxeland
