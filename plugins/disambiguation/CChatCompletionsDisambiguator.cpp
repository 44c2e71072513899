// SPDX-License-Identifier: BSD-3-Clause
#include "CChatCompletionsDisambiguator.h"

#include "ServerUrl.h"
#include "voxeland/base/RegisteredClass.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/hiddenTexts.h"
#include "voxeland/files/Json.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <random>
#include <thread>

namespace voxeland
{
IMPLEMENTS_MRPT_OBJECT(CChatCompletionsDisambiguator, voxeland::CDisambiguator, voxeland)

namespace
{
/** Whether a request leaves this machine, and unencrypted. */
bool isOpenToOthers(const std::string& url)
{
    return isUnencrypted(url) && !isThisMachine(url);
}

/** Tokens a server that does not count has probably used. */
uint64_t estimatedTokens(const DisambiguationQuestion& question, const std::string& answer)
{
    constexpr size_t BYTES_A_TOKEN = 4, TOKENS_A_PICTURE = 1000;
    return (question.prompt.size() + answer.size()) / BYTES_A_TOKEN +
           question.pictures.size() * TOKENS_A_PICTURE;
}

bool isWorthRetrying(long status)
{
    return status == 408 || status == 429 || status >= 500;
}

/** Something that waiting does not help, although the status says so. */
bool isHopeless(const std::string& reply)
{
    return reply.find("insufficient_quota") != std::string::npos ||
           remedyFor(serverMessage(reply)).has_value();
}
}  // namespace

std::string CChatCompletionsDisambiguator::description() const
{
    return "asks a vision-language model: OpenAI, vLLM, llama.cpp, Ollama or compatible";
}

void CChatCompletionsDisambiguator::declareOptions(OptionList& options)
{
    constexpr double MOST = std::numeric_limits<uint32_t>::max();
    options.addUrl("base_url", m_baseUrl,
                   "Where the server is, as far as /v1; by default Ollama on this machine");
    options.add("model", m_chat.model, "Model to ask, as the server calls it");
    options.addVariableName(
        "api_key_env", m_keyVariable,
        "Name of the environment variable with the server's key; empty: it needs none");
    options.add("send_key_unencrypted", m_keyUnencrypted,
                "Send the key to another machine even if base_url is not https",
                OptionList::noValue);
    options.add("ca_file", m_caFile,
                "PEM file with the certificates to trust instead of the system's; empty: those");
    options.add("max_run_tokens", m_maxRunTokens, {0, MOST},
                "No question is asked once so many tokens are used, prompts included; 0: no limit");
    options.forExperts();
    options.add("connect_timeout", m_connectTimeout, {0.001, 3600},
                "Longest time to wait for a connection [s]");
    options.add("timeout", m_timeout, {0.001, 86400}, "Longest time to wait for an answer [s]");
    options.add("retries", m_retries, {0, 100},
                "How often to ask again when a server is busy (429), fails (5xx) or is away");
    options.add("retry_delay", m_retryDelay, {0, 3600},
                "Time before the first of these, doubled for each other, unless the server's "
                "Retry-After says otherwise [s]");
    options.add("longest_retry_delay", m_longestRetryDelay, {0, 86400},
                "Longest such time; a server that wants more is given up [s]");
    options.add("give_up_after", m_giveUpAfter, {1, 1e6},
                "Questions in a row that fail before no other is asked");
    options.add("max_tokens", m_chat.maxTokens, {0, 1e6},
                "Longest answer, thoughts included [tokens]; 0: as the server likes");
    options.add("temperature", m_chat.temperature, {-1, 2},
                "Randomness of answers; negative: as the server likes");
    options.add("detail", m_chat.detail,
                "How closely to look at pictures, where servers know that: low | high | auto; "
                "empty: as the server likes");
    options.add("max_image_side", m_chat.pictures.side, {16, 16384},
                "Larger pictures are shrunk [pixels]");
    options.add("max_image_bytes", m_chat.pictures.bytes, {1000, 1e8},
                "Larger files are shrunk [bytes]");
    options.add("system_message", m_chat.systemMessage,
                "Sent before every question as the system's message; empty: none");
    options.add("extra_body", m_extraBody,
                "JSON object merged into every request, for what a server wants in addition; null "
                "removes a field");
}

std::vector<std::string> CChatCompletionsDisambiguator::configurationProblems()
{
    std::vector<std::string> problems;
    if (m_chat.model.empty()) problems.emplace_back("model is not given: name the model to ask");
    if (!m_caFile.empty() && !std::filesystem::is_regular_file(m_caFile))
        problems.emplace_back("ca_file = '" + m_caFile + "' is not a file");
    if (!m_extraBody.empty()) {
        m_chat.extra = jsonFrom(m_extraBody).value_or(nlohmann::json());
        if (!m_chat.extra.is_object())
            problems.emplace_back("extra_body = '" + m_extraBody + "' is not a JSON object");
    }
    if (m_keyVariable.empty()) return problems;
    const char* const key = std::getenv(m_keyVariable.c_str());
    if (key == nullptr) {
        problems.emplace_back(
            "the environment variable that api_key_env names is not set: export it, or leave "
            "api_key_env empty; it must be the name of a variable, not the key");
        return problems;
    }
    m_key = key;
    hideText(m_key, "*");
    const auto isVisible = [](unsigned char c) {
        return c > 0x20 && c < 0x7f && c != '"' && c != '\\';
    };
    if (m_key.empty() || !std::all_of(m_key.begin(), m_key.end(), isVisible))
        problems.emplace_back("the environment variable '" + m_keyVariable +
                              "' named by api_key_env holds no key: put one there, or leave "
                              "api_key_env empty");
    if (isOpenToOthers(m_baseUrl) && !m_keyUnencrypted)
        problems.emplace_back("the key would go to " + m_baseUrl +
                              " unencrypted: use https, or set send_key_unencrypted = true");
    return problems;
}

void CChatCompletionsDisambiguator::start()
{
    std::string all;
    for (const std::string& problem : configurationProblems())
        all += (all.empty() ? "[disambiguation] " : "; ") + problem;
    if (!all.empty()) throw ConfigurationError(all);
    m_url = chatUrl(m_baseUrl);
}

std::optional<DisambiguationAnswer> CChatCompletionsDisambiguator::ask(
    const DisambiguationQuestion& question) const
{
    if (m_maxRunTokens > 0 && m_run->tokens >= m_maxRunTokens)
        throw DisambiguationError(counted(m_run->tokens, "token") +
                                      " used, and [disambiguation] max_run_tokens "
                                      "allows no more: raise it to go on",
                                  true);
    try {
        DisambiguationAnswer answer = askPatiently(question);
        m_run->failuresInARow = 0;
        return answer;
    } catch (const DisambiguationError& e) {
        if (e.fatal || ++m_run->failuresInARow < m_giveUpAfter) throw;
        throw DisambiguationError(std::string(e.what()) + " (the last of " +
                                      counted(m_giveUpAfter, "question") + " in a row to fail)",
                                  true);
    }
}

DisambiguationAnswer CChatCompletionsDisambiguator::askPatiently(
    const DisambiguationQuestion& question) const
{
    using Clock = std::chrono::steady_clock;
    using nlohmann::json;
    const auto start = Clock::now();
    json body = chatRequest(question, m_chat);
    HttpRequest request{m_url, "", m_key, m_caFile, m_connectTimeout, m_timeout};
    HttpReply reply;
    do {
        request.body = body.dump(-1, ' ', false, json::error_handler_t::replace);
        reply = postPatiently(request);
    } while (reply.status == 400 && adaptRequest(body, reply.body));
    if (reply.status != 200) throw refusal(reply);

    DisambiguationAnswer answer;
    try {
        answer = chatAnswer(reply.body);
    } catch (const std::runtime_error& e) {
        throw DisambiguationError(sentence(e.what()), false);
    }
    answer.text = withoutHidden(answer.text);
    answer.model = withoutHidden(answer.model.empty() ? m_chat.model : answer.model);
    answer.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    const uint64_t counted = answer.promptTokens + answer.answerTokens;
    m_run->tokens += counted > 0 ? counted : estimatedTokens(question, answer.text);
    return answer;
}

HttpReply CChatCompletionsDisambiguator::postPatiently(HttpRequest& request) const
{
    for (uint32_t attempt = 0;; ++attempt) {
        try {
            HttpReply reply = post(request);
            if (!isWorthRetrying(reply.status) || isHopeless(reply.body)) return reply;
            if (!waitToRetry(attempt, reply.retryAfter)) return reply;
        } catch (const HttpError& e) {
            using Kind = HttpError::Kind;
            const bool retry = e.kind == Kind::NotConnected || e.kind == Kind::BrokenOff;
            if (retry && waitToRetry(attempt, std::nullopt)) continue;
            const bool isAway = e.kind == Kind::NotConnected || e.kind == Kind::Untrusted;
            throw DisambiguationError(
                sentence("cannot be asked: " + std::string(e.what()) +
                         (isAway                     ? ": check base_url and whether it runs"
                          : e.kind == Kind::TooLarge ? ": check base_url"
                                                     : ": try again, or raise [disambiguation] "
                                                       "timeout")),
                isAway);
        }
    }
}

bool CChatCompletionsDisambiguator::waitToRetry(uint32_t attempt,
                                                std::optional<double> retryAfter) const
{
    if (attempt >= m_retries || retryAfter.value_or(0) > m_longestRetryDelay) return false;
    thread_local std::mt19937 random(std::random_device{}());
    // So that parallel questions do not come back all at once.
    const double spread = std::uniform_real_distribution<double>(0.5, 1)(random);
    const double backoff =
        std::min(m_longestRetryDelay, m_retryDelay * std::pow(2.0, attempt)) * spread;
    std::this_thread::sleep_for(std::chrono::duration<double>(retryAfter.value_or(backoff)));
    return true;
}

DisambiguationError CChatCompletionsDisambiguator::refusal(const HttpReply& reply) const
{
    const std::string status = std::to_string(reply.status);
    constexpr size_t LONGEST = 120;
    std::string message = withoutHidden(serverMessage(reply.body));
    if (message.back() == '.') message.pop_back();  // the sentence goes on
    const std::string said = "(" + status + "): " + shortened(message, LONGEST);
    const auto remedy = remedyFor(message);
    switch (reply.status) {
        case 401:
            return {sentence(m_keyVariable.empty()
                                 ? "wants a key (401): name the environment variable that holds it "
                                   "in [disambiguation] api_key_env"
                                 : "does not accept the key in the environment variable " +
                                       m_keyVariable + " (401): check it"),
                    true};
        case 402:
        case 403:
            return {sentence("does not allow this with the key in the environment variable '" +
                             m_keyVariable + "' " + said),
                    true};
        case 404:
        case 405:
            return {sentence("has no such model or address: check model and base_url " + said),
                    true};
        case 429:
            return {sentence("does not accept more questions now, ask again later " + said), true};
        default:
            if (reply.status >= 300 && reply.status < 400)
                return {sentence("redirects (" + status + ") to '" + reply.location +
                                 "': if that is right, make it the base_url"),
                        true};
            return {sentence((reply.status >= 500 ? "failed " : "refuses the question ") + said +
                             (remedy ? ": " + remedy->clause : "")),
                    reply.status == 503 || (remedy && remedy->concernsAll)};
    }
}

std::string CChatCompletionsDisambiguator::sentence(const std::string& clause) const
{
    constexpr size_t LONGEST = 250;  // more may be said after it
    return shortened(withoutHidden("server " + m_url + " " + clause), LONGEST);
}
}  // namespace voxeland

const voxeland::RegisteredClass<voxeland::CChatCompletionsDisambiguator> REGISTERED;
