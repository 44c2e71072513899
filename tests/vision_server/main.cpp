// SPDX-License-Identifier: BSD-3-Clause
/** A server on 127.0.0.1 that speaks the chat completions protocol and recognises painted simulated
 * objects by the pixels of the pictures it is sent. Prints its port, then serves until it is ended.
 *
 *   vision_server [FOLDER]      each request is kept in the folder as N.json, its key as N.key
 *
 * What it does is chosen by the path before /v1/chat/completions: nothing (answers as well as it
 * can) or the name of a misbehaviour in behaviours(). */
#include "Connection.h"
#include "Sight.h"
#include "simulation/CategoryPaint.h"

#include <nlohmann/json.hpp>

#include <arpa/inet.h>
#include <atomic>
#include <chrono>
#include <ctime>
#include <fstream>
#include <functional>
#include <iostream>
#include <mutex>
#include <regex>
#include <set>
#include <stdexcept>
#include <sys/socket.h>
#include <thread>

using nlohmann::json;
using namespace voxeland::test;
namespace simulation = voxeland::simulation;

namespace
{
/** What a request asks. */
struct Question
{
    std::string words;
    std::vector<std::string> pictures;
};

std::string decodedBase64(const std::string& text)
{
    static const std::string DIGITS =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0, count = 0;
    for (const char c : text) {
        if (c == '=') break;
        const size_t digit = DIGITS.find(c);
        if (digit == std::string::npos) throw std::runtime_error("a picture is not base64");
        bits = bits << 6U | static_cast<unsigned>(digit);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> count & 0xffU);
    }
    return bytes;
}

/** \throws std::exception if the request does not keep to the protocol */
Question questionOf(const json& request)
{
    if (request.at("model").get<std::string>().empty()) throw std::runtime_error("no model");
    Question question;
    for (const json& part : request.at("messages").back().at("content")) {
        if (part.at("type") == "text") {
            question.words += part.at("text").get<std::string>();
            continue;
        }
        const std::string url = part.at("image_url").at("url");
        const size_t comma = url.find(";base64,");
        if (url.rfind("data:image/", 0) != 0 || comma == std::string::npos)
            throw std::runtime_error("a picture is no data URL");
        question.pictures.push_back(decodedBase64(url.substr(comma + 8)));
    }
    return question;
}

bool mentions(const std::string& words, const std::string& category)
{
    return std::regex_search(words, std::regex("\\b" + category + "\\b"));
}

/** The answer of somebody who looks at the pictures, and answers with what the question offers. */
std::string honestAnswer(const Question& question)
{
    const std::string seen = categoryShown(question.pictures);
    const bool offered = !seen.empty() && mentions(question.words, seen);
    return "The object category is " + (offered ? seen : "unknown") + ".";
}

/** Another of the answers that the question offers, whichever it is. */
std::string wrongAnswer(const Question& question)
{
    const std::string right = honestAnswer(question);
    for (const std::string& category : simulation::paintedCategories()) {
        std::string answer = "The object category is " + category + ".";
        if (answer != right && mentions(question.words, category)) return answer;
    }
    return "The object category is unknown.";
}

json completion(const json& content)
{
    return {{"id", "1"},
            {"object", "chat.completion"},
            {"model", "painted-objects"},
            {"choices",
             {{{"index", 0},
               {"finish_reason", "stop"},
               {"message", {{"role", "assistant"}, {"content", content}}}}}},
            {"usage", {{"prompt_tokens", 1200}, {"completion_tokens", 8}, {"total_tokens", 1208}}}};
}

json errorObject(const std::string& message, const std::string& parameter = "")
{
    return {{"error", {{"message", message}, {"type", "test"}, {"param", parameter}}}};
}

/** Whether this body comes for the first time. */
bool isNew(const Request& request)
{
    static std::mutex mutex;
    static std::set<std::string> seen;
    const std::lock_guard<std::mutex> lock(mutex);
    return seen.insert(request.path + request.body).second;
}

std::string httpDate(std::time_t time)
{
    char text[64];
    std::tm parts{};
    gmtime_r(&time, &parts);
    std::strftime(text, sizeof(text), "%a, %d %b %Y %H:%M:%S GMT", &parts);
    return text;
}

std::string repeated(const std::string& text, int times)
{
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
}

using Behaviour = std::function<void(Connection&, const Request&)>;

void answerHonestly(Connection& client, const Request& request)
{
    const Question question = questionOf(json::parse(request.body));
    client.answer(200, completion(honestAnswer(question)).dump());
}

/** Answers wrongly to so many of a hundred questions, to the same ones each time. */
Behaviour err(unsigned percent)
{
    return [percent](Connection& client, const Request& request) {
        const Question question = questionOf(json::parse(request.body));
        const bool errs = std::hash<std::string>()(request.body) % 100 < percent;
        client.answer(200,
                      completion(errs ? wrongAnswer(question) : honestAnswer(question)).dump());
    };
}

/** Answers with these words, whatever is asked. */
Behaviour say(const json& content)
{
    return [content](Connection& client, const Request&) {
        client.answer(200, completion(content).dump());
    };
}

/** A completion whose only choice is this. */
Behaviour choose(const json& choice)
{
    return [choice](Connection& client, const Request&) {
        client.answer(200, json{{"choices", {choice}}}.dump());
    };
}

Behaviour reply(int status, const std::string& body, const std::string& headers = "")
{
    return [=](Connection& client, const Request&) { client.answer(status, body, headers); };
}

/** Misbehaves when a request comes for the first time, then answers. */
Behaviour once(const Behaviour& first)
{
    return [first](Connection& client, const Request& request) {
        (isNew(request) ? first : answerHonestly)(client, request);
    };
}

/** Refuses requests with this field. */
Behaviour without(const std::string& field, const std::string& message)
{
    return [=](Connection& client, const Request& request) {
        if (json::parse(request.body).contains(field))
            client.answer(400, errorObject(message, field).dump());
        else
            answerHonestly(client, request);
    };
}

const std::map<std::string, Behaviour>& behaviours()
{
    static const std::string BUSY = errorObject("too many requests").dump();
    static const std::map<std::string, Behaviour> table = {
        {"", answerHonestly},
        {"/errs-10", err(10)},
        {"/errs-30", err(30)},
        {"/wrong-category", say("The object category is giraffe.")},
        {"/several-categories", say("The object category is chair, couch or dining table.")},
        {"/parts", say({{{"type", "text"}, {"text", "The object category is chair."}}})},
        {"/thinking", say("<think>A couch? No.</think>\n\nThe object category is chair.")},
        {"/empty-answer", say("")},
        {"/null-answer", say(nullptr)},
        {"/slow",
         [](Connection& client, const Request& request) {
             std::this_thread::sleep_for(std::chrono::seconds(20));
             answerHonestly(client, request);
         }},
        {"/leisurely",
         [](Connection& client, const Request& request) {
             std::this_thread::sleep_for(std::chrono::milliseconds(500));
             answerHonestly(client, request);
         }},
        {"/two-then-401",
         [](Connection& client, const Request& request) {
             static std::atomic<int> count{0};
             if (++count > 2)
                 client.answer(401, errorObject("invalid key").dump());
             else
                 answerHonestly(client, request);
         }},
        {"/400", reply(400, errorObject("too many pictures").dump())},
        {"/401", reply(401, errorObject("invalid key").dump())},
        {"/403", reply(403, errorObject("not in your region").dump())},
        {"/404", reply(404, R"({"error": "model \"m\" not found"})")},
        {"/429", reply(429, BUSY, "Retry-After: 0\r\n")},
        {"/429-long", reply(429, BUSY, "Retry-After: 3600\r\n")},
        {"/429-quota",
         reply(429, R"({"error": {"message": "no money", "code": "insufficient_quota"}})")},
        {"/429-once", once(reply(429, BUSY, "Retry-After: 1\r\n"))},
        {"/429-date-once", once([](Connection& client, const Request&) {
             client.answer(429, BUSY, "Retry-After: " + httpDate(std::time(nullptr) + 2) + "\r\n");
         })},
        {"/500", reply(500, "a stack trace\nof many lines")},
        {"/500-once", once(reply(500, ""))},
        {"/503", reply(503, R"({"detail": "loading the model"})")},
        {"/redirect", reply(307, "", "Location: http://127.0.0.1:9/elsewhere\r\n")},
        {"/garbage", reply(200, "<html>hello</html>")},
        {"/half", reply(200, completion("The object category is chair.").dump().substr(0, 90))},
        {"/no-choices", reply(200, R"({"choices": []})")},
        {"/error-in-200", reply(200, errorObject("out of memory").dump())},
        {"/uncounted", reply(200, R"({"choices": [{"message": {"content": "chair"}}]})")},
        {"/cut-short", reply(200, R"({"choices": [{"finish_reason": "length",
                                      "message": {"content": "<think>Hm"}}]})")},
        {"/cut-off", choose({{"finish_reason", "length"},
                             {"message", {{"content", "The object category is dini"}}}})},
        {"/reasoning",
         choose({{"finish_reason", "stop"},
                 {"message",
                  {{"content", nullptr}, {"reasoning_content", "The object category is chair"}}}})},
        {"/reasoning-cut",
         choose(
             {{"finish_reason", "length"},
              {"message", {{"content", nullptr}, {"reasoning", "The object category is chair"}}}})},
        {"/refusal", choose({{"finish_reason", "stop"},
                             {"message", {{"content", nullptr}, {"refusal", "I cannot help"}}}})},
        {"/filtered",
         choose({{"finish_reason", "content_filter"}, {"message", {{"content", ""}}}})},
        {"/tool",
         choose({{"finish_reason", "tool_calls"},
                 {"message",
                  {{"content", nullptr}, {"tool_calls", {{{"function", {{"name", "look"}}}}}}}}})},
        {"/stream",
         reply(200,
               ": comment\n\ndata: {\"model\": \"s\", \"choices\": [{\"delta\": {\"role\": "
               "\"assistant\"}}]}\n\ndata: {\"choices\": [{\"delta\": {\"content\": \"The object "
               "category\"}}]}\n\ndata: {\"choices\": [{\"delta\": {\"content\": \" is "
               "chair.\"}, \"finish_reason\": \"stop\"}], \"usage\": {\"prompt_tokens\": 9, "
               "\"completion_tokens\": 4}}\n\ndata: [DONE]\n\n")},
        {"/stream-error", reply(200, "data: {\"error\": {\"message\": \"out of memory\"}}\n\n")},
        {"/page", reply(502,
                        "<!DOCTYPE html>\n<html><head><title>502 Bad Gateway</title><style>b {a: "
                        "b > c}</style></head>\n<body><h1>Bad  Gateway</h1></body></html>\n")},
        {"/list-error", reply(404, json::array({errorObject("models/m is not found")}).dump())},
        {"/no-projector", reply(500, errorObject("image input is not supported - hint: if this is "
                                                 "unexpected, you may need to provide the mmproj")
                                         .dump())},
        {"/one-picture", reply(400, R"({"object": "error", "message":
             "At most 1 image(s) may be provided in one request."})")},
        {"/chatty", reply(400, errorObject("a" + repeated("\u00e4", 400)).dump())},
        {"/no-temperature-in-words",
         [](Connection& client, const Request& request) {
             if (json::parse(request.body).contains("temperature"))
                 client.answer(400, errorObject("temperature is not supported").dump());
             else
                 answerHonestly(client, request);
         }},
        {"/large-reply", reply(200, std::string((16U << 20U) + 1, ' '))},
        {"/many-headers", reply(200, "", repeated("X-More: of it\r\n", 10000))},
        {"/long-header", reply(200, "", "X-Long: " + std::string(5000000, 'x') + "\r\n")},
        {"/broken-off",
         [](Connection& client, const Request&) { client.answer(200, "{", "", 100); }},
        {"/broken-off-once",
         once([](Connection& client, const Request&) { client.answer(200, "{", "", 100); })},
        {"/echo-key",
         [](Connection& client, const Request& request) {
             client.answer(400,
                           errorObject("you sent " + request.headers.at("authorization")).dump());
         }},
        {"/answer-key",
         [](Connection& client, const Request& request) {
             client.answer(200, completion(request.headers.at("authorization")).dump());
         }},
        {"/no-max-tokens",
         without("max_tokens", "'max_tokens' is not supported. Use 'max_completion_tokens'.")},
        {"/no-temperature", without("temperature", "only the default is supported")},
    };
    return table;
}

void keep(const Request& request, const std::string& folder)
{
    static std::atomic<int> count{0};
    const std::string file = folder + "/" + std::to_string(++count);
    std::ofstream(file + ".json") << request.body;
    if (request.headers.count("authorization") > 0)
        std::ofstream(file + ".key") << request.headers.at("authorization");
}

void serve(int socket, const std::string& folder)
{
    Connection client(socket);
    const auto request = client.receive();
    if (!request) return;
    if (!folder.empty()) keep(*request, folder);
    const size_t common = request->path.find("/v1/chat/completions");
    const auto behaviour = behaviours().find(request->path.substr(0, common));
    try {
        if (common == std::string::npos || behaviour == behaviours().end())
            client.answer(404, errorObject("there is nothing at " + request->path).dump());
        else
            behaviour->second(client, *request);
    } catch (const std::exception& e) {
        client.answer(400, errorObject(e.what()).dump());
    }
}
}  // namespace

int main(int argc, char** argv)
{
    const std::string folder = argc > 1 ? argv[1] : "";
    const int listener = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof(address);
    auto* const generic = reinterpret_cast<sockaddr*>(&address);
    if (bind(listener, generic, size) != 0 || listen(listener, 64) != 0 ||
        getsockname(listener, generic, &size) != 0)
    {
        std::cerr << "cannot listen on 127.0.0.1\n";
        return 1;
    }
    std::cout << ntohs(address.sin_port) << std::endl;
    for (;;) {
        const int client = accept(listener, nullptr, nullptr);
        if (client >= 0) std::thread(serve, client, folder).detach();
    }
}
