// SPDX-License-Identifier: BSD-3-Clause
#include "RawlogPredictions.h"

#include "files/GzInputFile.h"
#include "files/GzOutputFile.h"
#include "observations/MaskCamera.h"
#include "rawlogs/StagedRawlog.h"
#include "voxeland/base/errors.h"
#include "voxeland/datasets/RgbdDatasetReader.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <filesystem>

namespace fs = std::filesystem;
using mrpt::obs::CObservation;
using mrpt::obs::CObservation3DRangeScan;
using mrpt::obs::CSensoryFrame;

namespace voxeland
{
namespace
{
/** Makes the predictions for the RGB-D frames of a rawlog, one after another. */
class FrameCounter
{
 public:
    FrameCounter(const std::string& rawlog, const PredictionSource& predictions, std::string label)
        : m_rawlog(rawlog), m_predictions(predictions), m_label(std::move(label))
    {
    }

    /** Predictions for an observation; null unless it is the next RGB-D frame. */
    CObservationInstances::Ptr instancesFor(const CObservation& observation)
    {
        const auto* scan = dynamic_cast<const CObservation3DRangeScan*>(&observation);
        if (!scan || !isChosen(scan->sensorLabel)) return nullptr;
        auto instances = m_predictions(m_added.frames++, *scan);
        if (!instances) return nullptr;
        attachToScan(*instances, *scan);
        m_added.predictions += instances->instances.size();
        return instances;
    }

    /** \throws NothingToMapError if there was none */
    void checkFound() const
    {
        if (m_added.frames == 0)
            throw NothingToMapError(
                m_rawlog + " has no RGB-D frames" +
                (m_label.empty() ? "" : " of a sensor labelled '" + m_label + "'"));
    }

    /** What was found so far. */
    [[nodiscard]] const AddedPredictions& added() const { return m_added; }

 private:
    bool isChosen(const std::string& label)
    {
        if (m_label.empty() && m_added.frames == 0) m_seen = label;
        if (!m_label.empty()) return label == m_label;
        if (label == m_seen) return true;
        throw ConfigurationError(m_rawlog + " has RGB-D frames of several sensors (" + m_seen +
                                 ", " + label + "): choose one with --sensor-label");
    }

    std::string m_rawlog;
    const PredictionSource& m_predictions;
    std::string m_label, m_seen;
    AddedPredictions m_added;
};

bool isPrediction(const mrpt::serialization::CSerializable& object)
{
    return dynamic_cast<const CObservationInstances*>(&object) != nullptr;
}

/** Goes through a rawlog and writes its predictions, alone or amid the objects they belong to. */
class PredictionsWriter
{
 public:
    PredictionsWriter(GzInputFile& in, GzOutputFile& out, FrameCounter& counter, bool embed)
        : m_in(in), m_out(out), m_counter(counter), m_embed(embed)
    {
    }

    /** Takes the object that was just read. */
    void take(const mrpt::serialization::CSerializable::Ptr& object)
    {
        if (const auto frame = std::dynamic_pointer_cast<CSensoryFrame>(object)) {
            takeSensoryFrame(*frame);
        } else if (isPrediction(*object)) {
            ++m_replaced;
        } else {
            if (m_embed) copyObject();
            if (const auto observation = std::dynamic_pointer_cast<CObservation>(object))
                if (const auto added = m_counter.instancesFor(*observation))
                    m_out.writeObject(*added);
        }
    }

    /** Observations of earlier predictions that were left out. */
    [[nodiscard]] size_t replaced() const { return m_replaced; }

 private:
    /** The bytes as they are: encoding images anew would change them. */
    void copyObject() { m_out.Write(m_in.objectBytes().data(), m_in.objectBytes().size()); }

    void takeSensoryFrame(const CSensoryFrame& frame)
    {
        CSensoryFrame changed;
        bool isChanged = false;
        for (const auto& observation : frame) {
            if (isPrediction(*observation)) {
                ++m_replaced;
                isChanged = true;
                continue;
            }
            changed.insert(observation);
            const auto added = m_counter.instancesFor(*observation);
            if (!added) continue;
            changed.insert(added);
            isChanged = true;
            if (!m_embed) m_out.writeObject(*added);
        }
        if (!m_embed) return;
        if (isChanged)
            m_out.writeObject(changed);
        else
            copyObject();
    }

    GzInputFile& m_in;
    GzOutputFile& m_out;
    FrameCounter& m_counter;
    const bool m_embed;
    size_t m_replaced = 0;
};

/** Makes a rawlog's external images found from a copy of it.
 *  \param link to be made, for the place where `target` is
 *  \return false if it has none */
bool linkImages(const fs::path& images, const fs::path& link, const fs::path& target)
{
    if (!fs::is_directory(images)) return false;
    const fs::path folder = fs::absolute(target).parent_path();
    fs::create_directory_symlink(fs::proximate(fs::canonical(images), fs::canonical(folder)), link);
    return true;
}
}  // namespace

AddedPredictions addPredictions(const std::string& input, const PredictionSource& predictions,
                                const std::string& output, const AddPredictionsOptions& options,
                                const std::function<void(size_t frames, double share)>& progress)
{
    const RawlogFiles source = RawlogFiles::toRead(input);
    source.useImages();
    GzInputFile in(input);
    if (options.embed) in.keepObjectBytes();
    StagedRawlog staged(output);
    std::error_code outputIsNew;
    const bool inPlace = fs::equivalent(source.rawlog, staged.target().rawlog, outputIsNew);
    if (inPlace) staged.keepImages();

    const auto written = options.embed ? &RawlogFiles::rawlog : &RawlogFiles::sidecar;
    GzOutputFile out((staged.part().*written).string(), GzOutputFile::FASTEST,
                     (staged.target().*written).string());
    FrameCounter counter(input, predictions, options.sensorLabel);
    PredictionsWriter writer(in, out, counter, options.embed);
    while (const auto object = in.readObject()) {
        writer.take(object);
        if (writer.replaced() > 0 && !options.embed)
            throw InputError(input + " has predictions inside: use --embed to replace them");
        progress(counter.added().frames, in.progress());
    }
    out.close();

    AddedPredictions added = counter.added();
    added.replaced = writer.replaced();
    added.rawlogWritten = options.embed || !inPlace;
    counter.checkFound();
    try {
        if (!inPlace && !options.embed) fs::copy_file(source.rawlog, staged.part().rawlog);
        if (!inPlace)
            added.imagesLinked =
                linkImages(source.images, staged.part().images, staged.target().images);
    } catch (const fs::filesystem_error& e) {
        throw OutputError("cannot copy " + input + " to " + output + ": " + e.code().message());
    }
    staged.putInPlace();
    return added;
}

std::vector<DatasetFrame> rgbdFramesOf(const std::string& rawlog, const std::string& sensorLabel)
{
    std::vector<DatasetFrame> frames;
    const PredictionSource list = [&](size_t number, const CObservation3DRangeScan& scan) {
        const auto& image = scan.intensityImage;
        frames.push_back({static_cast<int64_t>(number),
                          image.isExternallyStored() ? image.getExternalStorageFile() : ""});
        return nullptr;
    };
    FrameCounter counter(rawlog, list, sensorLabel);
    GzInputFile in(RawlogFiles::toRead(rawlog).rawlog.string());
    while (const auto object = in.readObject()) {
        if (const auto frame = std::dynamic_pointer_cast<CSensoryFrame>(object))
            for (const auto& observation : *frame) counter.instancesFor(*observation);
        else if (const auto observation = std::dynamic_pointer_cast<CObservation>(object))
            counter.instancesFor(*observation);
    }
    counter.checkFound();
    return frames;
}

PredictionSource recordedPredictions(MatchedPredictions& predictions)
{
    return [&](size_t frame, const CObservation3DRangeScan& scan) {
        const auto& camera = maskCamera(scan);
        return predictions.instancesFor(frame, static_cast<int>(camera.ncols),
                                        static_cast<int>(camera.nrows));
    };
}
}  // namespace voxeland
