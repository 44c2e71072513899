// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "ChatProtocol.h"
#include "HttpPost.h"
#include "voxeland/plugins/CDisambiguator.h"

#include <atomic>
#include <memory>

namespace voxeland
{
/** Asks a vision-language model behind the chat completions protocol: OpenAI, vLLM, llama.cpp's
 * server, Ollama and others. The key comes from an environment variable and is in no message,
 * answer or file. */
class CChatCompletionsDisambiguator : public CDisambiguator
{
    DEFINE_MRPT_OBJECT(CChatCompletionsDisambiguator, voxeland)

 public:
    [[nodiscard]] std::string description() const override;
    void declareOptions(OptionList& options) override;
    /** \throws ConfigurationError with everything that is wrong with the keys together */
    void start() override;
    [[nodiscard]] std::optional<DisambiguationAnswer> ask(
        const DisambiguationQuestion& question) const override;

 private:
    /** Asks until there is an answer, or no hope. */
    [[nodiscard]] DisambiguationAnswer askPatiently(const DisambiguationQuestion& question) const;
    /** Sends a request, again if the server has no time or the connection fails. */
    [[nodiscard]] HttpReply postPatiently(HttpRequest& request) const;
    /** Waits before the next attempt. \return false if there should be none */
    bool waitToRetry(uint32_t attempt, std::optional<double> retryAfter) const;
    /** What to say of a reply that is not an answer. */
    [[nodiscard]] DisambiguationError refusal(const HttpReply& reply) const;
    /** A sentence about the server; what it said itself is shortened, and shows nothing hidden. */
    [[nodiscard]] std::string sentence(const std::string& clause) const;
    [[nodiscard]] std::vector<std::string> configurationProblems();

    std::string m_baseUrl = "http://127.0.0.1:11434/v1", m_keyVariable, m_caFile, m_extraBody;
    bool m_keyUnencrypted = false;
    double m_timeout = 120, m_connectTimeout = 10;
    uint32_t m_retries = 4, m_maxRunTokens = 0, m_giveUpAfter = 3;
    double m_retryDelay = 1, m_longestRetryDelay = 60;
    ChatOptions m_chat;

    std::string m_url, m_key;

    /** What changes while questions are asked. */
    struct Run
    {
        std::atomic<uint64_t> tokens{0};          //!< used so far
        std::atomic<uint32_t> failuresInARow{0};  //!< questions without an answer
    };
    std::shared_ptr<Run> m_run = std::make_shared<Run>();
};
}  // namespace voxeland
