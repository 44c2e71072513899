// SPDX-License-Identifier: BSD-3-Clause
#include "UnfinishedPredictions.h"

#include "voxeland/base/errors.h"

#include <mrpt/serialization/CSerializable.h>

namespace voxeland
{
UnfinishedPredictions::UnfinishedPredictions(const std::string& file, const std::string& origin)
    : m_journal(file, "voxeland unfinished predictions 2", origin)
{
}

CObservationInstances::Ptr UnfinishedPredictions::of(size_t frame,
                                                     const mrpt::obs::CObservation3DRangeScan& scan,
                                                     const PredictionSource& source)
{
    if (frame < frames()) return nextKept();
    const auto predictions = source(frame, scan);
    keep(predictions.get());
    return predictions;
}

CObservationInstances::Ptr UnfinishedPredictions::nextKept()
{
    const auto bytes = m_journal.next();
    mrpt::serialization::CSerializable::Ptr object;
    if (bytes && !bytes->empty()) mrpt::serialization::OctetVectorToObject(*bytes, object);
    const auto predictions = std::dynamic_pointer_cast<CObservationInstances>(object);
    if (!predictions && bytes && !bytes->empty())
        throw InputError(m_journal.file() +
                         " is damaged: remove it, and what it holds is made again");
    return predictions;
}

void UnfinishedPredictions::keep(const CObservationInstances* predictions)
{
    RecordJournal::Bytes bytes;
    if (predictions != nullptr) mrpt::serialization::ObjectToOctetVector(predictions, bytes);
    m_journal.append(bytes);
}
}  // namespace voxeland
