// SPDX-License-Identifier: BSD-3-Clause
#include "ChatProtocol.h"

#include "voxeland/base/trimmed.h"
#include "voxeland/disambiguation/Thoughts.h"
#include "voxeland/files/Json.h"

#include <mrpt/system/string_utils.h>

#include <algorithm>
#include <cstring>
#include <sstream>

namespace voxeland
{
using nlohmann::json;

namespace
{
/** Without the line breaks that MRPT puts in: a URL has none. */
std::string base64(const std::string& bytes)
{
    std::string text;
    mrpt::system::encodeBase64({bytes.begin(), bytes.end()}, text);
    text.erase(
        std::remove_if(text.begin(), text.end(), [](char c) { return c == '\r' || c == '\n'; }),
        text.end());
    return text;
}

bool removeEnd(std::string& text, const std::string& end)
{
    if (text.size() < end.size() || text.compare(text.size() - end.size(), end.size(), end) != 0)
        return false;
    text.resize(text.size() - end.size());
    return true;
}

/** The words of a message, which are a text or a list of parts. */
std::string words(const json& content)
{
    if (content.is_string()) return content.get<std::string>();
    std::string text;
    if (content.is_array())
        for (const json& part : content)
            if (part.is_object() && part.contains("text") && part["text"].is_string())
                text += part["text"].get<std::string>();
    return text;
}

/** Member of an object as text; empty if it is not one. */
std::string textMember(const json& object, const char* name)
{
    if (!object.is_object() || !object.contains(name) || !object[name].is_string()) return {};
    return object[name].get<std::string>();
}

/** First element of a list that is one; null if there is none. */
json firstMember(const json& object, const char* name)
{
    const json list = object.is_object() ? object.value(name, json()) : json();
    return list.is_array() && !list.empty() ? list.front() : json();
}

uint64_t countMember(const json& object, const char* name)
{
    if (!object.is_object() || !object.contains(name) || !object[name].is_number_unsigned())
        return 0;
    return object[name].get<uint64_t>();
}
/** What a model thought before it answered, where servers keep that apart. */
std::string reasoningOf(const json& message)
{
    const std::string thoughts = textMember(message, "reasoning_content");
    return thoughts.empty() ? textMember(message, "reasoning") : thoughts;
}

/** A reply that came in pieces although that was not asked for, as the lines "data: {...}" of a
 * stream, in one piece; any other as it is; nothing if it is neither. */
std::optional<json> wholeReply(const std::string& reply)
{
    if (auto body = jsonFrom(reply)) return body;
    static const std::string DATA = "data:";
    json whole = json::object(), choice = json::object();
    std::string content, reasoning;
    std::istringstream lines(reply);
    for (std::string line; std::getline(lines, line);) {
        if (line.compare(0, DATA.size(), DATA) != 0) continue;
        const json piece = jsonFrom(line.substr(DATA.size())).value_or(json());
        if (!piece.is_object()) continue;
        for (const char* name : {"model", "usage", "error"})
            if (piece.contains(name) && !piece[name].is_null()) whole[name] = piece[name];
        const json part = firstMember(piece, "choices");
        if (!part.is_object()) continue;
        const json delta = part.value("delta", json());
        content += textMember(delta, "content");
        reasoning += reasoningOf(delta);
        choice["finish_reason"] = part.value("finish_reason", json());
    }
    if (choice.empty() && !whole.contains("error")) return std::nullopt;
    if (!choice.empty()) {
        choice["message"] = {{"content", content}, {"reasoning", reasoning}};
        whole["choices"] = json::array({choice});
    }
    return whole;
}

/** Why there is no answer in a message. */
std::string emptiness(const json& choice)
{
    const std::string reason = textMember(choice, "finish_reason");
    if (reason == "length")
        return "reached max_tokens before it answered: raise [disambiguation] max_tokens, or what "
               "the server allows";
    if (reason == "content_filter") return "withheld the answer (content_filter)";
    if (reason == "tool_calls" || !firstMember(choice["message"], "tool_calls").is_null())
        return "called a tool instead of answering: switch its tools off, or take another model";
    return "sent an empty answer";
}

/** The words of a page without its tags, style and scripts; any other text as it is. */
std::string withoutTags(const std::string& page)
{
    if (page.compare(0, 1, "<") != 0) return page;
    std::string text;
    for (size_t at = 0; at < page.size();) {
        const size_t begin = std::min(page.size(), page.find('<', at));
        text += page.substr(at, begin - at) + " ";
        at = begin;
        for (const char* whole : {"<style", "<script"})
            if (page.compare(begin, std::strlen(whole), whole) == 0)
                at = std::min(page.size(), page.find("</", begin));
        at = std::min(page.size(), page.find('>', at));
        if (at < page.size()) ++at;
    }
    return text;
}

/** In one line, each run of blanks one. */
std::string oneLine(const std::string& text)
{
    std::string line;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        const bool isBlank = byte <= 0x20 || byte == 0x7f;
        if (!isBlank)
            line += c;
        else if (!line.empty() && line.back() != ' ')
            line += ' ';
    }
    return trimmed(line);
}
}  // namespace

std::string chatUrl(std::string url)
{
    while (removeEnd(url, "/")) {
    }
    removeEnd(url, "/chat/completions");
    const size_t scheme = url.find("://");
    const size_t host = scheme == std::string::npos ? 0 : scheme + 3;
    if (url.find('/', host) == std::string::npos) url += "/v1";
    return url + "/chat/completions";
}

json chatRequest(const DisambiguationQuestion& question, const ChatOptions& options)
{
    json content = json::array();
    content.push_back({{"type", "text"}, {"text", question.prompt}});
    for (const DisambiguationPicture& original : question.pictures) {
        const DisambiguationPicture picture = fitted(original, options.pictures);
        json image = {{"url", "data:" + picture.mediaType + ";base64," + base64(picture.bytes)}};
        if (!options.detail.empty()) image["detail"] = options.detail;
        content.push_back({{"type", "image_url"}, {"image_url", image}});
    }
    json messages = json::array();
    if (!options.systemMessage.empty())
        messages.push_back({{"role", "system"}, {"content", options.systemMessage}});
    messages.push_back({{"role", "user"}, {"content", content}});

    json request = {{"model", options.model}, {"messages", messages}, {"stream", false}};
    if (options.maxTokens > 0) request["max_tokens"] = options.maxTokens;
    if (options.temperature >= 0) request["temperature"] = options.temperature;
    request.merge_patch(options.extra);
    return request;
}

bool adaptRequest(json& request, const std::string& error)
{
    const json reply = jsonFrom(error).value_or(json());
    const json details = reply.is_object() ? reply.value("error", json()) : json();
    const std::string parameter = textMember(details, "param"), message = serverMessage(error);
    const auto concerns = [&](const std::string& name) {
        const bool isNamed =
            parameter.empty() ? message.find(name) != std::string::npos : parameter == name;
        return isNamed && request.contains(name);
    };
    if (concerns("max_tokens") && message.find("max_completion_tokens") != std::string::npos) {
        request["max_completion_tokens"] = request["max_tokens"];
        request.erase("max_tokens");
        return true;
    }
    return concerns("temperature") && request.erase("temperature") > 0;
}

DisambiguationAnswer chatAnswer(const std::string& reply)
{
    const auto whole = wholeReply(reply);
    if (!whole) throw std::runtime_error("sent no valid JSON: " + serverMessage(reply));
    const json& body = *whole;
    if (!body.is_object() || !body.contains("choices"))
        throw std::runtime_error(
            "sent no chat completion: " +
            serverMessage(body.dump(-1, ' ', false, json::error_handler_t::replace)));
    const json choice = firstMember(body, "choices");
    if (!choice.is_object() || !choice.contains("message") || !choice["message"].is_object())
        throw std::runtime_error("sent a chat completion without a message");

    const json& message = choice["message"];
    const bool isCutOff = textMember(choice, "finish_reason") == "length";
    DisambiguationAnswer answer;
    answer.text = withoutThoughts(words(message.value("content", json())));
    if (answer.text.empty()) answer.text = trimmed(textMember(message, "refusal"));
    if (answer.text.empty() && !isCutOff) answer.text = withoutThoughts(reasoningOf(message));
    if (answer.text.empty()) throw std::runtime_error(emptiness(choice));
    if (isCutOff) answer.text += " [cut off by max_tokens]";
    answer.model = textMember(body, "model");
    const json usage = body.value("usage", json());
    answer.promptTokens = countMember(usage, "prompt_tokens");
    answer.answerTokens = countMember(usage, "completion_tokens");
    return answer;
}

std::string serverMessage(const std::string& reply)
{
    json body = jsonFrom(reply).value_or(json());
    if (body.is_array() && !body.empty()) body = json(body.front());  // Gemini
    std::string message;
    if (body.is_object()) {
        // OpenAI, llama.cpp and new vLLM; Ollama's own errors; old vLLM; web frameworks.
        const json error = body.value("error", json());
        for (const std::string& candidate :
             {textMember(error, "message"), textMember(body, "error"), textMember(body, "message"),
              textMember(body, "detail")})
            if (message.empty()) message = candidate;
    }
    message = oneLine(message.empty() ? withoutTags(trimmed(reply)) : message);
    return message.empty() ? "nothing" : message;
}

std::optional<Remedy> remedyFor(const std::string& message)
{
    static const Remedy BLIND = {"choose a model that takes pictures", true};
    static const Remedy FEWER = {
        "lower [disambiguation] views_per_category, max_categories or picture_size", false};
    static const std::pair<const char*, const Remedy*> SYMPTOMS[] = {
        {"mmproj", &BLIND},  // llama.cpp
        {"image input is not supported", &BLIND},
        {"cannot unmarshal array", &BLIND},  // Ollama
        {"unknown variant `image_url`", &BLIND},
        {"image_url is only supported", &BLIND},
        {"not a multimodal model", &BLIND},  // vLLM
        {"not support image", &BLIND},
        {"support image input", &BLIND},       // "no endpoints found that support image input"
        {"image(s) may be provided", &FEWER},  // vLLM
        {"too many images", &FEWER},
        {"many pictures", &FEWER},
        {"context length", &FEWER},
        {"context size", &FEWER},
        {"context window", &FEWER},
    };
    for (const auto& [symptom, remedy] : SYMPTOMS)
        if (message.find(symptom) != std::string::npos) return *remedy;
    return std::nullopt;
}

std::string shortened(const std::string& text, size_t longest)
{
    constexpr unsigned IS_WITHIN = 0xc0, WITHIN = 0x80;  // a character of UTF-8
    if (text.size() <= longest) return text;
    while (longest > 0 && (static_cast<unsigned char>(text[longest]) & IS_WITHIN) == WITHIN)
        --longest;
    return trimmed(text.substr(0, longest)) + "...";
}
}  // namespace voxeland
