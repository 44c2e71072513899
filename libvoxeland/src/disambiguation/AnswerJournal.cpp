// SPDX-License-Identifier: BSD-3-Clause
#include "AnswerJournal.h"

#include "map/InstanceSerialization.h"
#include "voxeland/base/errors.h"

#include <mrpt/io/CMemoryStream.h>

#include <array>
#include <zlib.h>

namespace voxeland
{
namespace
{
/** What tells a file's content from others. */
std::string contentOf(const std::string& file)
{
    std::ifstream in(file, std::ios::binary);
    std::array<char, 65536> bytes{};
    uLong checksum = crc32_z(0, nullptr, 0);
    uint64_t size = 0;
    while (in.read(bytes.data(), bytes.size()) || in.gcount() > 0) {
        const auto n = static_cast<size_t>(in.gcount());
        checksum = crc32_z(checksum, reinterpret_cast<const Bytef*>(bytes.data()), n);
        size += n;
    }
    if (!in.eof()) throw InputError("cannot read " + file + ": check the disk");
    return std::to_string(size) + " bytes " + std::to_string(checksum);
}
}  // namespace

AnswerJournal::AnswerJournal(const std::string& output, const std::string& map,
                             const std::string& source)
    : m_journal(output + ".answers", "voxeland answers 1", contentOf(map) + " " + source)
{
}

size_t AnswerJournal::replay(const SemanticVoxelMap& map,
                             const std::function<void(instance_id_t, const Decision&)>& give)
{
    while (auto record = m_journal.next()) {
        mrpt::io::CMemoryStream stream(record->data(), record->size());
        auto archive = mrpt::serialization::archiveFrom(stream);
        try {
            const auto instance = archive.ReadAs<instance_id_t>();
            const Decision decision = readDecision(archive, map.categories());
            if (map.instances().count(instance) > 0) give(instance, decision);
        } catch (const std::exception&) {
            throw InputError(m_journal.file() +
                             " is damaged: remove it, and what it holds is asked again");
        }
    }
    return m_journal.kept();
}

void AnswerJournal::add(instance_id_t instance, const Decision& decision)
{
    mrpt::io::CMemoryStream stream;
    auto archive = mrpt::serialization::archiveFrom(stream);
    archive << instance;
    write(archive, decision);
    const auto* bytes = static_cast<const uint8_t*>(stream.getRawBufferData());
    m_journal.append({bytes, bytes + stream.getTotalBytesCount()});
}
}  // namespace voxeland
