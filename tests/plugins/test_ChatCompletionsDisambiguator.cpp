// SPDX-License-Identifier: BSD-3-Clause
/** The back-end that asks a server, against a real one (tests/vision_server). */
#include "Backend.h"
#include "simulation/CategoryPaint.h"
#include "support/RunProgram.h"
#include "support/TestFiles.h"
#include "support/VisionServer.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include <chrono>
#include <cstdlib>
#include <future>

using namespace voxeland;
using nlohmann::json;
using test::couchOrChair;
namespace fs = std::filesystem;

namespace
{
constexpr auto KEY = "sk-Secret-0123456789", KEY_VARIABLE = "VOXELAND_TEST_KEY";

class ChatCompletions : public testing::Test
{
 protected:
    ChatCompletions()
    {
        setenv(KEY_VARIABLE, KEY, 1);
        setenv("no_proxy", "127.0.0.1", 1);
    }

    /** The back-end for a server that behaves like this; little patience. */
    [[nodiscard]] std::shared_ptr<CDisambiguator> asking(const std::string& behaviour,
                                                         const std::string& keys = "") const
    {
        return askingAt(m_server.url(behaviour), keys);
    }
    [[nodiscard]] static std::shared_ptr<CDisambiguator> askingAt(const std::string& url,
                                                                  const std::string& keys = "")
    {
        return test::backend("chat_completions", "CChatCompletionsDisambiguator",
                             "base_url = " + url + "\nmodel = m\napi_key_env = " + KEY_VARIABLE +
                                 "\nretry_delay = 0.01\nretries = 2\n" + keys);
    }
    static std::string answerOf(const std::shared_ptr<CDisambiguator>& backend)
    {
        return backend->ask(couchOrChair())->text;
    }
    /** What is thrown, which never shows the key. */
    static DisambiguationError errorOf(const std::shared_ptr<CDisambiguator>& backend)
    {
        try {
            const auto answer = backend->ask(couchOrChair());
            ADD_FAILURE() << "answered " << answer->text;
        } catch (const DisambiguationError& e) {
            EXPECT_EQ(std::string(e.what()).find(KEY), std::string::npos) << e.what();
            EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
            return e;
        }
        return {"", false};
    }
    static void expectError(const DisambiguationError& e, bool fatal, const std::string& part)
    {
        EXPECT_EQ(e.fatal, fatal) << e.what();
        EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
    }
    [[nodiscard]] size_t requests() const
    {
        size_t count = 0;
        for (const auto& entry : fs::directory_iterator(m_kept.path()))
            if (entry.path().extension() == ".json") ++count;
        return count;
    }
    [[nodiscard]] json request(int number = 1) const
    {
        return json::parse(test::readFile(m_kept.file(std::to_string(number) + ".json")));
    }

    test::TemporaryFolder m_kept;
    test::VisionServer m_server{m_kept.path().string()};
};

DisambiguationQuestion painted(const std::string& category)
{
    const auto colour = simulation::paintOf(category);
    return couchOrChair({255 * colour.b, 255 * colour.g, 255 * colour.r});
}

double secondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}
}  // namespace

TEST_F(ChatCompletions, theServerSeesThePictures)
{
    const auto backend = asking("");
    for (const char* category : {"chair", "couch"}) {
        const auto answer = backend->ask(painted(category));
        ASSERT_TRUE(answer);
        EXPECT_EQ(answer->text, std::string("The object category is ") + category + ".");
        EXPECT_EQ(answer->model, "painted-objects");
        EXPECT_EQ(answer->promptTokens, 1200U);
        EXPECT_EQ(answer->answerTokens, 8U);
        EXPECT_GT(answer->seconds, 0);
    }
    EXPECT_EQ(backend->ask(painted("bed"))->text, "The object category is unknown.")
        << "a bed was not offered";
    EXPECT_EQ(answerOf(backend), "The object category is unknown.") << "nothing is painted";
}

TEST_F(ChatCompletions, theRequestIsTheQuestion)
{
    const DisambiguationQuestion question = couchOrChair();
    ASSERT_TRUE(asking("",
                       "system_message = Be brief\ndetail = low\nmax_tokens = 50\n"
                       "temperature = 0\nextra_body = {\"seed\": 3, \"stream\": null}\n")
                    ->ask(question));
    const json body = request();
    EXPECT_EQ(body["model"], "m");
    EXPECT_EQ(body["max_tokens"], 50);
    EXPECT_EQ(body["temperature"], 0);
    EXPECT_EQ(body["seed"], 3);
    EXPECT_FALSE(body.contains("stream"));
    ASSERT_EQ(body["messages"].size(), 2U);
    EXPECT_EQ(body["messages"][0], (json{{"role", "system"}, {"content", "Be brief"}}));
    EXPECT_EQ(body["messages"][1]["role"], "user");
    const json content = body["messages"][1]["content"];
    ASSERT_EQ(content.size(), 3U);
    EXPECT_EQ(content[0], (json{{"type", "text"}, {"text", question.prompt}}));
    EXPECT_EQ(content[1]["type"], "image_url");
    EXPECT_EQ(content[1]["image_url"]["detail"], "low");
    const std::string first = content[1]["image_url"]["url"],
                      second = content[2]["image_url"]["url"];
    EXPECT_EQ(first.rfind("data:image/png;base64,iVBORw0KGgo", 0), 0U) << first;
    EXPECT_EQ(second.rfind("data:image/jpeg;base64,/9j/", 0), 0U) << second;
    EXPECT_EQ(test::readFile(m_kept.file("1.key")), std::string("Bearer ") + KEY);
}

TEST_F(ChatCompletions, whatIsNotConfiguredIsNotMentioned)
{
    ASSERT_TRUE(test::backend("chat_completions", "CChatCompletionsDisambiguator",
                              "model = m\nbase_url = " + m_server.url() + "\n")
                    ->ask(couchOrChair()));
    const json body = request();
    EXPECT_EQ(body.size(), 3U) << body.dump();
    EXPECT_EQ(body["messages"].size(), 1U);
    EXPECT_FALSE(body["messages"][0]["content"][1]["image_url"].contains("detail"));
    EXPECT_FALSE(fs::exists(m_kept.file("1.key")));
}

TEST_F(ChatCompletions, theAddressMayBeWrittenInSeveralWays)
{
    const std::string url = m_server.url(), root = url.substr(0, url.size() - 3);
    for (const std::string& way : {url, url + "/", url + "/chat/completions", root, root + "/"})
        EXPECT_NO_THROW(answerOf(askingAt(way))) << way;
}

TEST_F(ChatCompletions, largePicturesAreShrunk)
{
    cv::Mat noise(600, 800, CV_8UC3);
    cv::randu(noise, 0, 256);
    std::vector<uchar> file;
    cv::imencode(".png", noise, file);
    DisambiguationQuestion question = couchOrChair();
    question.pictures[0].bytes.assign(file.begin(), file.end());
    const auto sent = [&](const std::string& keys, int number) {
        EXPECT_TRUE(asking("", keys)->ask(question));
        return request(number)["messages"][0]["content"][1]["image_url"]["url"].get<std::string>();
    };
    const auto picture = [](const std::string& url) {
        const std::string text = url.substr(url.find(',') + 1);
        std::vector<uchar> bytes;
        for (size_t i = 0; i + 3 < text.size(); i += 4) {
            static const std::string DIGITS =
                "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
            unsigned three = 0;
            for (size_t k = 0; k < 4; ++k)
                three = three * 64 +
                        (text[i + k] == '=' ? 0U : static_cast<unsigned>(DIGITS.find(text[i + k])));
            for (const unsigned shift : {16U, 8U, 0U})
                bytes.push_back(static_cast<uchar>(three >> shift));
        }
        return cv::imdecode(bytes, cv::IMREAD_COLOR);
    };
    const std::string bySide = sent("max_image_side = 200\n", 1);
    EXPECT_EQ(picture(bySide).size(), cv::Size(200, 150));
    EXPECT_EQ(bySide.rfind("data:image/jpeg", 0), 0U);
    const std::string byBytes = sent("max_image_bytes = 20000\n", 2);
    EXPECT_LE((byBytes.size() - byBytes.find(',') - 1) / 4 * 3, 20000U);
    EXPECT_GT(picture(byBytes).cols, 50);
    const std::string asItWas = sent("max_image_bytes = 10000000\n", 3);
    EXPECT_EQ(asItWas.rfind("data:image/png", 0), 0U);
}

TEST_F(ChatCompletions, aPictureThatIsNoneIsNotSent)
{
    DisambiguationQuestion question = couchOrChair();
    question.pictures[1].bytes = "hello";
    EXPECT_THROW((void)asking("")->ask(question), DisambiguationError);
    question.pictures[1].bytes.clear();
    EXPECT_THROW((void)asking("")->ask(question), DisambiguationError);
    EXPECT_EQ(requests(), 0U);
}

TEST_F(ChatCompletions, answersAreReadWhateverTheirForm)
{
    EXPECT_EQ(answerOf(asking("parts")), "The object category is chair.");
    EXPECT_EQ(answerOf(asking("thinking")), "The object category is chair.");
    EXPECT_EQ(answerOf(asking("reasoning")), "The object category is chair");
    EXPECT_EQ(answerOf(asking("refusal")), "I cannot help");
    EXPECT_EQ(answerOf(asking("cut-off")), "The object category is dini [cut off by max_tokens]");
    const auto streamed = asking("stream")->ask(couchOrChair());
    EXPECT_EQ(streamed->text, "The object category is chair.");
    EXPECT_EQ(streamed->model, "s");
    EXPECT_EQ(streamed->promptTokens, 9U);
    const auto uncounted = asking("uncounted")->ask(couchOrChair());
    EXPECT_EQ(uncounted->text, "chair");
    EXPECT_EQ(uncounted->model, "m") << "as configured, where the server does not say";
    EXPECT_EQ(uncounted->promptTokens, 0U);
}

TEST_F(ChatCompletions, refusedFieldsAreAdapted)
{
    EXPECT_NO_THROW(answerOf(asking("no-max-tokens", "max_tokens = 50\n")));
    EXPECT_EQ(request(2)["max_completion_tokens"], 50);
    EXPECT_NO_THROW(answerOf(asking("no-temperature", "temperature = 0\n")));
    EXPECT_FALSE(request(4).contains("temperature"));
    EXPECT_NO_THROW(answerOf(asking("no-temperature-in-words", "temperature = 0\n")));
    EXPECT_FALSE(request(6).contains("temperature"));
}

TEST_F(ChatCompletions, refusalsThatNoOtherQuestionWouldEscape)
{
    expectError(errorOf(asking("401")), true, KEY_VARIABLE);
    expectError(errorOf(asking("403")), true, "not in your region");
    expectError(errorOf(asking("404")), true, "model \"m\" not found");
    expectError(errorOf(asking("429-quota")), true, "no money");
    expectError(errorOf(asking("429-long")), true, "too many requests");
    expectError(errorOf(asking("redirect")), true, "http://127.0.0.1:9/elsewhere");
    expectError(errorOf(asking("no-such-behaviour")), true, "nothing at");
    expectError(errorOf(asking("list-error")), true, "(404): models/m is not found");
    expectError(errorOf(asking("no-projector")), true, "choose a model that takes pictures");
    EXPECT_EQ(requests(), 9U) << "no second attempt";
    expectError(errorOf(asking("401", "api_key_env =\n")), true, "api_key_env");
}

TEST_F(ChatCompletions, repliesBeyondAnyAnswerAreNotReceived)
{
    for (const auto& [behaviour, told] :
         {std::pair("large-reply", "its reply is larger than 16 MiB"),
          std::pair("many-headers", "the headers of its reply are larger than 64 KiB"),
          std::pair("long-header", "the headers of its reply are larger than 64 KiB")})
        expectError(errorOf(asking(behaviour)), false, told);
    EXPECT_EQ(requests(), 3U) << "no second attempt";
}

TEST_F(ChatCompletions, refusalsOfOneQuestion)
{
    expectError(errorOf(asking("400")), false, "too many pictures");
    expectError(errorOf(asking("garbage")), false, "no valid JSON: hello");
    expectError(errorOf(asking("half")), false, "no valid JSON");
    expectError(errorOf(asking("no-choices")), false, "without a message");
    expectError(errorOf(asking("error-in-200")), false, "out of memory");
    expectError(errorOf(asking("empty-answer")), false, "empty answer");
    expectError(errorOf(asking("null-answer")), false, "empty answer");
    expectError(errorOf(asking("cut-short")), false, "raise [disambiguation] max_tokens");
    expectError(errorOf(asking("reasoning-cut")), false, "raise [disambiguation] max_tokens");
    expectError(errorOf(asking("filtered")), false, "content_filter");
    expectError(errorOf(asking("tool")), false, "called a tool");
    expectError(errorOf(asking("stream-error")), false, "sent no chat completion: out of memory");
    expectError(errorOf(asking("one-picture")), false,
                "in one request: lower [disambiguation] views_per_category");
    EXPECT_EQ(requests(), 13U) << "no second attempt";
}

TEST_F(ChatCompletions, aPageIsReadWithoutItsTagsAndALongMessageIsCutBetweenCharacters)
{
    expectError(errorOf(asking("page", "retries = 0\n")), false,
                "failed (502): 502 Bad Gateway Bad Gateway");
    const std::string chatty = errorOf(asking("chatty")).what();
    EXPECT_LT(chatty.size(), 300U);
    EXPECT_EQ(chatty.substr(chatty.size() - 5), "\u00e4...") << chatty;
}

TEST_F(ChatCompletions, asksAgainWhereThatMayHelp)
{
    expectError(errorOf(asking("429")), true, "too many requests");
    EXPECT_EQ(requests(), 3U);
    expectError(errorOf(asking("500")), false, "a stack trace of many lines");
    EXPECT_EQ(requests(), 6U);
    expectError(errorOf(asking("503")), true, "loading the model");
    EXPECT_EQ(requests(), 9U);
    expectError(errorOf(asking("broken-off")), false, "cannot be asked");
    EXPECT_EQ(requests(), 12U);
    EXPECT_NO_THROW(answerOf(asking("500-once")));
    EXPECT_NO_THROW(answerOf(asking("broken-off-once")));
    EXPECT_EQ(requests(), 16U);
}

TEST_F(ChatCompletions, waitsAsLongAsTheServerWants)
{
    for (const char* behaviour : {"429-once", "429-date-once"}) {
        const auto start = std::chrono::steady_clock::now();
        EXPECT_NO_THROW(answerOf(asking(behaviour)));
        EXPECT_GE(secondsSince(start), 0.95) << behaviour;
    }
    EXPECT_EQ(requests(), 4U);
}

TEST_F(ChatCompletions, aSlowServerIsNotWaitedForForever)
{
    const auto start = std::chrono::steady_clock::now();
    expectError(errorOf(asking("slow", "timeout = 0.3\n")), false,
                "raise [disambiguation] timeout");
    EXPECT_LT(secondsSince(start), 10);
    EXPECT_EQ(requests(), 1U) << "an answer may already be paid for";
}

TEST_F(ChatCompletions, aServerThatIsDown)
{
    const std::string url = m_server.url();
    m_server.stop();
    expectError(errorOf(askingAt(url)), true, "check base_url");
    expectError(errorOf(askingAt("http://no-such-host.invalid/v1", "send_key_unencrypted = yes\n")),
                true, "check base_url");
}

TEST_F(ChatCompletions, noProxySeesWhatStaysOnThisMachine)
{
    fs::create_directory(m_kept.file("proxied"));
    const test::VisionServer proxy(m_kept.file("proxied"));
    unsetenv("no_proxy");
    for (const char* variable : {"http_proxy", "all_proxy"}) {
        setenv(variable, ("http://127.0.0.1:" + proxy.port()).c_str(), 1);
        EXPECT_NE(answerOf(asking("")), "");
        unsetenv(variable);
    }
    EXPECT_EQ(requests(), 2U);
    EXPECT_TRUE(fs::is_empty(m_kept.file("proxied")));
}

TEST_F(ChatCompletions, noProxySeesAKeyInClear)
{
    fs::create_directory(m_kept.file("proxied"));
    const test::VisionServer proxy(m_kept.file("proxied"));
    unsetenv("no_proxy");
    setenv("http_proxy", ("http://127.0.0.1:" + proxy.port()).c_str(), 1);
    const auto chat = [](const std::string& keys) {
        return test::backend("chat_completions", "CChatCompletionsDisambiguator",
                             "model = m\nretries = 0\nsend_key_unencrypted = true\n" + keys);
    };
    for (const char* url : {"http://no-such-host.invalid/v1", "http://127.0.0.1.invalid/v1"})
        expectError(errorOf(chat("base_url = " + std::string(url) +
                                 "\napi_key_env = " + KEY_VARIABLE + "\n")),
                    true, "cannot be asked");
    EXPECT_TRUE(fs::is_empty(m_kept.file("proxied")));
    // Without a key a proxy is what the user wants: it answers, though not well.
    expectError(errorOf(chat("base_url = http://no-such-host.invalid/v1\n")), true, "(404)");
    unsetenv("http_proxy");
}

TEST_F(ChatCompletions, aKeyOfOneStarIsHiddenToo)
{
    setenv(KEY_VARIABLE, "*", 1);
    EXPECT_NE(answerOf(asking("")), "");
}

TEST_F(ChatCompletions, onlyATrustedServerIsAskedOverHttps)
{
    const auto secure = [this](const std::string& subject) {
        const auto made = test::runProgram(
            "openssl", {"req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj",
                        "/CN=test", "-addext", "subjectAltName=" + subject, "-keyout",
                        m_kept.file("key.pem"), "-out", m_kept.file("certificate.pem")});
        EXPECT_EQ(made.exitCode, 0) << made.errors;
        return std::make_unique<test::ServerProcess>(
            std::vector<std::string>{"python3", VOXELAND_TLS_FRONT, m_kept.file("certificate.pem"),
                                     m_kept.file("key.pem"), m_server.port()});
    };
    const std::string trust = "ca_file = " + m_kept.file("certificate.pem") + "\n";
    const auto other = secure("DNS:example.org");
    const std::string otherUrl = "https://127.0.0.1:" + other->port() + "/v1";
    expectError(errorOf(askingAt(otherUrl, trust)), true, "check base_url");
    const auto server = secure("IP:127.0.0.1");
    const std::string url = "https://127.0.0.1:" + server->port() + "/v1";
    expectError(errorOf(askingAt(url)), true, "certificate");
    EXPECT_EQ(requests(), 0U);
    EXPECT_NO_THROW(answerOf(askingAt(url, trust)));
    EXPECT_EQ(requests(), 1U);
}

TEST_F(ChatCompletions, severalFailuresInARowEndTheRun)
{
    const auto backend = asking("garbage", "give_up_after = 3\n");
    EXPECT_FALSE(errorOf(backend).fatal);
    EXPECT_FALSE(errorOf(backend).fatal);
    expectError(errorOf(backend), true, "last of 3 questions in a row");
}

TEST_F(ChatCompletions, tokensAreCapped)
{
    const auto backend = asking("", "max_run_tokens = 2000\n");
    EXPECT_NO_THROW(answerOf(backend));  // 1208
    EXPECT_NO_THROW(answerOf(backend));
    expectError(errorOf(backend), true, "2416 tokens");
    EXPECT_EQ(requests(), 2U);
    const auto uncounted = asking("uncounted", "max_run_tokens = 1000\n");
    EXPECT_NO_THROW(answerOf(uncounted));  // two pictures: about 2000
    expectError(errorOf(uncounted), true, "max_run_tokens");
}

TEST_F(ChatCompletions, severalThreadsAskAtOnce)
{
    const auto backend = asking("500-once");
    std::vector<std::future<std::string>> answers;
    for (int i = 0; i < 16; ++i)
        answers.push_back(std::async(std::launch::async, [&backend, i] {
            DisambiguationQuestion question = painted(i % 2 == 0 ? "chair" : "couch");
            question.prompt += std::to_string(i);
            return backend->ask(question)->text;
        }));
    for (size_t i = 0; i < answers.size(); ++i)
        EXPECT_EQ(answers[i].get(),
                  i % 2 == 0 ? "The object category is chair." : "The object category is couch.");
    EXPECT_EQ(requests(), 32U);
}

TEST_F(ChatCompletions, theKeyIsShownNowhere)
{
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    expectError(errorOf(asking("echo-key")), false, "you sent Bearer *");
    EXPECT_EQ(answerOf(asking("answer-key")), "Bearer *");
    for (const char* behaviour : {"401", "403", "500", "redirect", "broken-off"})
        errorOf(asking(behaviour));
    const auto object = createPlugin<CDisambiguator>("CChatCompletionsDisambiguator");
    OptionList options;
    object->declareOptions(options);
    std::ostringstream printed;
    options.print(printed, "disambiguation");
    EXPECT_EQ(printed.str().find(KEY), std::string::npos);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");

    const test::TemporaryFolder recorded;
    test::writeFile(
        recorded.file("server.ini"),
        "[disambiguation]\nclass = CChatCompletionsDisambiguator\nmodel = m\nbase_url = " +
            m_server.url("answer-key") + "\napi_key_env = " + KEY_VARIABLE + "\n");
    ASSERT_TRUE(test::backend("replay", "CReplayDisambiguator",
                              "folder = " + recorded.file("q") +
                                  "\nrecord_config = " + recorded.file("server.ini") + "\n")
                    ->ask(couchOrChair()));
    size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(recorded.path()))
        if (entry.is_regular_file()) {
            EXPECT_EQ(test::readFile(entry.path()).find(KEY), std::string::npos) << entry.path();
            ++files;
        }
    EXPECT_EQ(files, 6U);
}

TEST_F(ChatCompletions, wrongKeysAreNamedTogether)
{
    const auto problemsOf = [](const std::string& keys) -> std::string {
        try {
            (void)test::backend("chat_completions", "CChatCompletionsDisambiguator", keys);
        } catch (const ConfigurationError& e) {
            return e.what();
        }
        return "";
    };
    const std::string all = problemsOf(
        "api_key_env = VOXELAND_NO_SUCH_KEY\nca_file = /no/such.pem\nextra_body = [1]\n");
    for (const char* part : {"model", "api_key_env", "/no/such.pem", "[1]"})
        EXPECT_NE(all.find(part), std::string::npos) << all;
    EXPECT_EQ(all.find("VOXELAND_NO_SUCH_KEY"), std::string::npos) << "it may be the key itself";
    const std::string key =
        std::string("model = m\napi_key_env = ") + KEY_VARIABLE + "\nbase_url = ";
    for (const char* open : {"http://example.org/v1", "http://127.0.0.1.example.org/v1",
                             "http://127.evil.com/v1", "http://localhost.evil.com/v1"})
        EXPECT_NE(problemsOf(key + open + "\n").find("unencrypted"), std::string::npos) << open;
    for (const char* ok : {"https://example.org/v1", "http://localhost:1/v1", "http://[::1]:8/v1",
                           "http://example.org/v1\nsend_key_unencrypted = true"})
        EXPECT_EQ(problemsOf(key + ok + "\n"), "");
    setenv(KEY_VARIABLE, "two\nlines", 1);
    EXPECT_NE(problemsOf(key + "https://example.org\n").find("holds no key"), std::string::npos);
}
