// SPDX-License-Identifier: BSD-3-Clause
#include "DryRun.h"

#include "Questions.h"
#include "voxeland/base/errors.h"
#include "voxeland/files/AtomicFile.h"
#include "voxeland/files/OutputFolder.h"
#include "voxeland/files/WrittenFiles.h"

#include <mrpt/core/format.h>
#include <nlohmann/json.hpp>

namespace voxeland
{
namespace
{
using json_t = nlohmann::ordered_json;

std::string pictureName(size_t number, const DisambiguationPicture& picture)
{
    const char* extension = picture.mediaType == "image/png" ? "png" : "jpg";
    return mrpt::format("picture-%02zu.%s", number, extension);
}

/** Writes a question's folder. \return what questions.json says of it */
json_t write(const DisambiguationQuestion& question, const std::string& folder)
{
    const std::string name = "instance-" + std::to_string(question.instance);
    makeOutputFolder(folder + "/" + name);
    writeAtomically(folder + "/" + name + "/prompt.txt", question.prompt);
    json_t json = {{"instance", question.instance}, {"folder", name}};
    json["candidates"] = json_t::object();
    for (const RankedCategory& c : question.candidates) json["candidates"][c.name] = c.probability;
    json["pictures"] = json_t::array();
    for (size_t i = 0; i < question.pictures.size(); ++i) {
        const DisambiguationPicture& picture = question.pictures[i];
        const std::string file = pictureName(i + 1, picture);
        writeAtomically(folder + "/" + name + "/" + file, picture.bytes);
        json["pictures"].push_back({{"file", file}, {"caption", picture.caption}});
    }
    json["tokens"] = estimatedTokens(question);
    return json;
}
}  // namespace

Estimate estimate(const std::vector<DisambiguationQuestion>& questions,
                  const DisambiguationOptions& options)
{
    Estimate e;
    e.questions = questions.size();
    for (const DisambiguationQuestion& q : questions) {
        e.pictures += q.pictures.size();
        e.tokens += estimatedTokens(q);
    }
    e.cost = costOf(e.tokens, e.questions * ANSWER_TOKENS, options);
    return e;
}

void writeQuestions(const std::vector<DisambiguationQuestion>& questions,
                    const DisambiguationOptions& options, const std::string& folder)
{
    makeOutputFolder(folder);
    const Estimate e = estimate(questions, options);
    json_t json = {
        {"questions", json_t::array()}, {"estimated_tokens", e.tokens}, {"estimated_cost", e.cost}};
    WrittenFiles complete;
    try {
        for (const DisambiguationQuestion& q : questions) {
            json["questions"].push_back(write(q, folder));
            complete.add(json["questions"].back()["folder"]);
        }
        writeAtomically(folder + "/questions.json",
                        json.dump(2, ' ', false, json_t::error_handler_t::replace) + "\n");
    } catch (const OutputError& e) {
        throw OutputError(
            e.what() + (complete.names().empty() ? "; no question is complete" : complete.told()));
    }
}
}  // namespace voxeland
