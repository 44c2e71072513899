// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <string>

namespace voxeland
{
/** What JSON that others wrote may hold. What is deeper would end a program where it is copied or
 *  written, as that goes down by recursion; each value takes up to 100 bytes of memory. */
struct JsonLimits
{
    static constexpr size_t DEPTH = 100;         //!< lists and objects in each other
    static constexpr size_t VALUES = 50000000;   //!< members, elements, lists and objects
    static constexpr size_t BYTES = 1000000000;  //!< of the text
};

/** Parses JSON, for all that is read. NaN and Infinity, which Python writes and JSON lacks, are
 * read as null. \param source where the text comes from, for the message \throws InputError, with
 * line and column, if it is not valid or beyond JsonLimits */
nlohmann::json parseJson(const std::string& text, const std::string& source);

/** The same; nothing where parseJson() throws. */
std::optional<nlohmann::json> jsonFrom(const std::string& text);

/** Reads and parses a JSON file. \throws InputError if it cannot be read, or as parseJson() */
nlohmann::json readJson(const std::string& file);

/** The same; objects in lines of their own (JSON Lines) are read as a list of them. */
nlohmann::json readJsonOrLines(const std::string& file);
}  // namespace voxeland
