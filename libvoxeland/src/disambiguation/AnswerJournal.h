// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "files/RecordJournal.h"
#include "voxeland/map/SemanticVoxelMap.h"

#include <functional>
#include <string>

namespace voxeland
{
/** The answers of a run that asks about a map, kept one by one in `OUTPUT.answers` until the map is
 * written: a run that is killed loses none. */
class AnswerJournal
{
 public:
    /** \param output map that the run will write
     *  \param map file of the map it asks about \param source class of the back-end: answers about
     * another map, or of another back-end, are not kept
     *  \throws OutputError if it cannot be written, InputError if the map cannot be read */
    AnswerJournal(const std::string& output, const std::string& map, const std::string& source);

    /** Gives the answers of a run that was killed, in their order. \return how many there were
     *  \throws InputError if they are damaged */
    size_t replay(const SemanticVoxelMap& map,
                  const std::function<void(instance_id_t, const Decision&)>& give);
    /** Keeps an answer. \throws OutputError if it cannot be kept */
    void add(instance_id_t instance, const Decision& decision);
    /** Removes the file, once the map is written. */
    void discard() { m_journal.discard(); }

 private:
    RecordJournal m_journal;
};
}  // namespace voxeland
