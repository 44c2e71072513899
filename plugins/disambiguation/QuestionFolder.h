// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/plugins/CDisambiguator.h"

#include <filesystem>
#include <optional>
#include <string>

namespace voxeland
{
/** A question on disk, and its answer if there is one:
 *
 *  | file | content |
 *  |---|---|
 *  | prompt.txt | the question in words |
 *  | picture-01.jpg ... | its pictures (or .png) |
 *  | question.json | instance, candidates, what each picture shows |
 *  | answer.txt | the answer a person writes; lines that start with # do not count |
 *  | answer.json | the answer that was recorded |
 *
 * A person's answer counts more than a recorded one. */
class QuestionFolder
{
 public:
    /** Nothing is written yet. The name follows from instance, prompt and pictures: the same
     * question has the same folder, and another map's question has another. */
    QuestionFolder(const std::filesystem::path& parent, const DisambiguationQuestion& question);

    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }
    /** None if there is none yet. \throws DisambiguationError if it cannot be read */
    [[nodiscard]] std::optional<DisambiguationAnswer> answer() const;

    /** Writes the question. \throws OutputError if that fails */
    void writeQuestion(const DisambiguationQuestion& question) const;
    /** Asks a person: writes answer.txt with instructions unless it exists.
     *  \throws OutputError if that fails */
    void writeForm(const DisambiguationQuestion& question) const;
    /** Records an answer. \throws OutputError if that fails */
    void writeAnswer(const DisambiguationAnswer& answer) const;

 private:
    std::filesystem::path m_path;
};
}  // namespace voxeland
