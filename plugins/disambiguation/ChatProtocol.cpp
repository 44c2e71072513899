// SPDX-License-Identifier: BSD-3-Clause
#include "ChatProtocol.h"

#include "voxeland/trimmed.h"

#include <mrpt/system/string_utils.h>

#include <algorithm>

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

/** Some servers leave what a model thinks before it answers in the answer. */
std::string withoutThoughts(const std::string& text)
{
    static const std::string BEGIN = "<think>", END = "</think>";
    const size_t end = text.rfind(END);
    if (end != std::string::npos) return trimmed(text.substr(end + END.size()));
    const std::string all = trimmed(text);
    return all.compare(0, BEGIN.size(), BEGIN) == 0 ? std::string() : all;
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

uint64_t countMember(const json& object, const char* name)
{
    if (!object.is_object() || !object.contains(name) || !object[name].is_number_unsigned())
        return 0;
    return object[name].get<uint64_t>();
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
    const json reply = json::parse(error, nullptr, false);
    const json details = reply.is_object() ? reply.value("error", json()) : json();
    const std::string parameter = textMember(details, "param");
    if (parameter == "max_tokens" && request.contains(parameter) &&
        textMember(details, "message").find("max_completion_tokens") != std::string::npos)
    {
        request["max_completion_tokens"] = request[parameter];
        request.erase(parameter);
        return true;
    }
    return parameter == "temperature" && request.erase(parameter) > 0;
}

DisambiguationAnswer chatAnswer(const std::string& reply)
{
    const json body = json::parse(reply, nullptr, false);
    if (body.is_discarded())
        throw std::runtime_error("sent no valid JSON: " + serverMessage(reply));
    if (!body.is_object() || !body.contains("choices"))
        throw std::runtime_error("sent no chat completion: " + serverMessage(reply));
    const json& choices = body["choices"];
    if (!choices.is_array() || choices.empty() || !choices[0].is_object() ||
        !choices[0].contains("message") || !choices[0]["message"].is_object())
        throw std::runtime_error("sent a chat completion without a message");

    const json& message = choices[0]["message"];
    DisambiguationAnswer answer;
    answer.text = withoutThoughts(words(message.value("content", json())));
    if (answer.text.empty()) answer.text = trimmed(textMember(message, "refusal"));
    if (answer.text.empty())
        throw std::runtime_error(
            textMember(choices[0], "finish_reason") == "length"
                ? "reached max_tokens before it answered: raise [disambiguation] max_tokens"
                : "sent an empty answer");
    answer.model = textMember(body, "model");
    const json usage = body.value("usage", json());
    answer.promptTokens = countMember(usage, "prompt_tokens");
    answer.answerTokens = countMember(usage, "completion_tokens");
    return answer;
}

std::string serverMessage(const std::string& reply)
{
    const json body = json::parse(reply, nullptr, false);
    std::string message;
    if (body.is_object()) {
        // OpenAI, llama.cpp and new vLLM; Ollama's own errors; old vLLM; web frameworks.
        const json error = body.value("error", json());
        for (const std::string& candidate :
             {textMember(error, "message"), textMember(body, "error"), textMember(body, "message"),
              textMember(body, "detail")})
            if (message.empty()) message = candidate;
    }
    if (message.empty()) message = reply;
    constexpr auto isControl = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
    std::replace_if(message.begin(), message.end(), isControl, ' ');
    message = trimmed(message);
    return message.empty() ? "nothing" : message;
}
}  // namespace voxeland
