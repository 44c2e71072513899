// SPDX-License-Identifier: BSD-3-Clause
#include "QuestionFolder.h"

#include "voxeland/base/errors.h"
#include "voxeland/base/printable.h"
#include "voxeland/base/trimmed.h"
#include "voxeland/files/AtomicFile.h"
#include "voxeland/files/Json.h"
#include "voxeland/files/OutputFolder.h"

#include <fstream>
#include <sstream>

namespace fs = std::filesystem;
using nlohmann::json;

namespace voxeland
{
namespace
{
constexpr auto PERSONS_ANSWER = "answer.txt", RECORDED_ANSWER = "answer.json";

/** FNV-1a, a hash that is the same everywhere and always. */
class Hash
{
 public:
    void add(const std::string& text)
    {
        for (const char c : text) add(static_cast<unsigned char>(c));
        add(0x100);  // so that "ab","c" and "a","bc" differ
    }
    [[nodiscard]] std::string text() const
    {
        std::ostringstream hex;
        hex << std::hex << m_value;
        return hex.str();
    }

 private:
    void add(unsigned symbol) { m_value = (m_value ^ symbol) * 0x100000001b3U; }
    uint64_t m_value = 0xcbf29ce484222325U;
};

std::string folderName(const DisambiguationQuestion& question)
{
    Hash hash;
    hash.add(question.prompt);
    for (const DisambiguationPicture& picture : question.pictures) hash.add(picture.bytes);
    return "instance-" + std::to_string(question.instance) + "-" + hash.text();
}

std::string pictureName(size_t index, const DisambiguationPicture& picture)
{
    const std::string number = std::to_string(index + 1);
    return "picture-" + (number.size() < 2 ? "0" : std::string()) + number +
           (picture.mediaType == "image/png" ? ".png" : ".jpg");
}

std::string questionJson(const DisambiguationQuestion& question)
{
    json candidates = json::array(), pictures = json::array();
    for (const RankedCategory& c : question.candidates)
        candidates.push_back({{"category", c.name}, {"probability", c.probability}});
    for (size_t i = 0; i < question.pictures.size(); ++i)
        pictures.push_back({{"file", pictureName(i, question.pictures[i])},
                            {"caption", question.pictures[i].caption}});
    return json{{"instance", question.instance}, {"candidates", candidates}, {"pictures", pictures}}
        .dump(2, ' ', false, json::error_handler_t::replace);
}

std::string form(const DisambiguationQuestion& question)
{
    std::string categories;
    for (const RankedCategory& c : question.candidates) categories += printable(c.name) + ", ";
    return "# What is it? Look at the pictures beside this file; prompt.txt says what they show.\n"
           "# Then write below which of these it is: " +
           categories + "unknown\n# Lines that start with # do not count.\n";
}

/** What a person wrote: all but the lines that start with #, without space around. */
std::string readPersonsAnswer(const fs::path& file)
{
    std::ifstream in;
    if (fs::is_regular_file(file)) in.open(file);
    static const std::string BYTE_ORDER_MARK = "\xef\xbb\xbf";
    std::string text;
    for (std::string line; std::getline(in, line);) {
        if (line.compare(0, BYTE_ORDER_MARK.size(), BYTE_ORDER_MARK) == 0)
            line.erase(0, BYTE_ORDER_MARK.size());
        const std::string words = trimmed(line);
        if (words.empty() || words[0] == '#') continue;
        text += (text.empty() ? "" : "\n") + words;
    }
    return text;
}
}  // namespace

QuestionFolder::QuestionFolder(const fs::path& parent, const DisambiguationQuestion& question)
    : m_path(parent / folderName(question))
{
}

std::optional<DisambiguationAnswer> QuestionFolder::answer() const
{
    DisambiguationAnswer answer;
    answer.text = readPersonsAnswer(m_path / PERSONS_ANSWER);
    if (!answer.text.empty()) {
        answer.model = "a person";
        return answer;
    }
    const fs::path file = m_path / RECORDED_ANSWER;
    if (!fs::exists(file)) return std::nullopt;
    try {
        const json recorded = readJson(file.string());
        answer.text = recorded.at("text");
        answer.model = recorded.at("model");
        answer.promptTokens = recorded.at("prompt_tokens");
        answer.answerTokens = recorded.at("answer_tokens");
        answer.seconds = recorded.at("seconds");
    } catch (const InputError& e) {
        throw DisambiguationError(std::string(e.what()) + ": remove it to ask again", false);
    } catch (const json::exception&) {
        throw DisambiguationError(file.string() + " is no recorded answer: remove it to ask again",
                                  false);
    }
    return answer;
}

void QuestionFolder::writeQuestion(const DisambiguationQuestion& question) const
{
    makeOutputFolder(m_path.string());
    writeAtomically((m_path / "prompt.txt").string(), question.prompt);
    for (size_t i = 0; i < question.pictures.size(); ++i)
        writeAtomically((m_path / pictureName(i, question.pictures[i])).string(),
                        question.pictures[i].bytes);
    writeAtomically((m_path / "question.json").string(), questionJson(question) + "\n");
}

void QuestionFolder::writeForm(const DisambiguationQuestion& question) const
{
    const fs::path file = m_path / PERSONS_ANSWER;
    if (!fs::exists(file)) writeAtomically(file.string(), form(question));
}

void QuestionFolder::writeAnswer(const DisambiguationAnswer& answer) const
{
    const json recorded = {{"text", answer.text},
                           {"model", answer.model},
                           {"prompt_tokens", answer.promptTokens},
                           {"answer_tokens", answer.answerTokens},
                           {"seconds", answer.seconds}};
    writeAtomically((m_path / RECORDED_ANSWER).string(),
                    recorded.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
}
}  // namespace voxeland
