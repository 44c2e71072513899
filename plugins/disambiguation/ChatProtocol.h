// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "PictureLimits.h"
#include "voxeland/plugins/CDisambiguator.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

/** \file
 * The chat completions protocol, and where servers speak it differently. */
namespace voxeland
{
/** What a request says besides the question. */
struct ChatOptions
{
    std::string model;
    std::string systemMessage;  //!< empty: none
    std::string detail;         //!< of the pictures: low, high, auto; empty: not mentioned
    uint32_t maxTokens = 0;     //!< of an answer; 0: not mentioned
    double temperature = -1;    //!< negative: not mentioned
    nlohmann::json extra = nlohmann::json::object();  //!< fields added to the request
    PictureLimits pictures;
};

/** Where requests go: `base_url` with or without a slash at its end, `/v1`, `/chat/completions`. */
std::string chatUrl(std::string baseUrl);

/** The request for a question: its words, then its pictures as data URLs, in one message. */
nlohmann::json chatRequest(const DisambiguationQuestion& question, const ChatOptions& options);

/** Mends a request that a server refused because it calls a field otherwise, or does not let it be
 * chosen. \param error the body of its answer \return whether there was something to mend */
bool adaptRequest(nlohmann::json& request, const std::string& error);

/** The answer in a server's reply.
 *  \throws std::runtime_error with a clause that says what is wrong with the reply */
DisambiguationAnswer chatAnswer(const std::string& reply);

/** What a server says is wrong: its own words, or whatever it sent without tags, in one line. */
std::string serverMessage(const std::string& reply);

/** What helps against a server's message. */
struct Remedy
{
    std::string clause;
    bool concernsAll = false;  //!< whether no other question would escape
};
/** None if the message is not one that is known. */
std::optional<Remedy> remedyFor(const std::string& message);

/** The beginning of a text, of so many bytes at most, and "..." if that is not all. */
std::string shortened(const std::string& text, size_t longest);
}  // namespace voxeland
