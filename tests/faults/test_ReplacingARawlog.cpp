// SPDX-License-Identifier: BSD-3-Clause
#include "Attempts.h"
#include "datasets/RawlogPredictions.h"
#include "support/Frames.h"
#include "support/TestFiles.h"
#include "voxeland/rawlogs/RawlogFrameSource.h"
#include "voxeland/rawlogs/RgbdRawlogWriter.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <csignal>
#include <iostream>
#include <set>
#include <sstream>

using namespace voxeland;
using namespace voxeland::test;
namespace fs = std::filesystem;

namespace
{
constexpr int FRAMES = 2;
constexpr unsigned MOST = 1000;  // attempts, of a kind: all

/** Writes a rawlog whose frames, at the same times as others', are all of that depth and colour. */
void write(const std::string& file, float depth, uint8_t grey, const std::string& category,
           const RgbdRawlogWriter::Options& options = {})
{
    RgbdRawlogWriter writer(file, options);
    for (int i = 0; i < FRAMES; ++i) {
        RgbdRecord record;
        record.scan = makeScan([&](int, int) { return depth; }, 1000 + i);
        auto& scan = *record.scan;
        scan.hasIntensityImage = true;
        scan.intensityImage.resize(8, 6, mrpt::img::CH_RGB);
        scan.intensityImage.filledRectangle(0, 0, 7, 5, {grey, grey, grey});
        record.robotPose = std::make_shared<mrpt::math::TPose3D>();
        if (!category.empty())
            record.instances =
                makePredictions({prediction(rectangleMask(0, 0, 5, 5), category, 0.5F)}, 1000 + i);
        writer.write(record);
    }
    writer.close();
}

/** What a reader sees of a rawlog: of each frame depth, colour and predictions. */
std::string seenIn(const std::string& file)
{
    std::ostringstream seen;
    RawlogFrameSource source(file, {}, {});
    while (const auto frame = source.next()) {
        auto& scan = const_cast<mrpt::obs::CObservation3DRangeScan&>(*frame->scan);
        scan.load();
        seen << scan.rangeImage(0, 0) << ' ' << int(scan.intensityImage.at<uint8_t>(3, 3)) << ' ';
        if (frame->instances)
            for (const auto& i : frame->instances->instances)
                seen << i.categories.front().name << ' ';
        seen << '\n';
    }
    seen << source.skipped().predictionsWithoutFrame;
    return seen.str();
}

std::set<std::string> filesIn(const fs::path& folder)
{
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        names.insert(fs::relative(entry.path(), folder));
    return names;
}

void copyAll(const fs::path& from, const fs::path& to)
{
    fs::remove_all(to);
    fs::copy(from, to, fs::copy_options::recursive | fs::copy_options::copy_symlinks);
}

/** A rawlog, and something that replaces it; what it becomes is known from a try without faults. */
class Replacing
{
 public:
    Replacing(const std::function<void(const std::string& file)>& old,
              std::function<void(const std::string& file)> replacement)
        : m_replacement(std::move(replacement))
    {
        const std::string begin = m_folder.file("begin");
        fs::create_directory(begin);
        old(begin + "/k.rawlog");
        m_old = seenIn(begin + "/k.rawlog");
        setUp();
        m_replacement(rawlog());
        m_new = seenIn(rawlog());
        m_newFiles = filesIn(now());
    }

    /** Tries every call of a kind. \return attempts */
    unsigned check(Calls kind, int error, unsigned times = ONCE)
    {
        std::set<std::string> results;
        setUp();
        const auto work = [&] { m_replacement(rawlog()); };
        const unsigned attempts =
            attemptAll(kind, error, times, MOST, work, [&](const Attempt& end) {
                EXPECT_TRUE(error == KILL ? end.signal == SIGKILL || end.exitCode == 0
                                          : end.signal == 0)
                    << end.signal;
                EXPECT_TRUE(std::set<int>({-1, 0, 3, 5}).count(end.exitCode))
                    << end.exitCode << end.message;
                const std::string seen = seenIn(rawlog());
                EXPECT_TRUE(seen == m_old || seen == m_new) << seen << end.message;
                if (end.exitCode == 0) {
                    EXPECT_EQ(seen, m_new);
                }
                results.insert(seen);
                m_replacement(rawlog());
                EXPECT_EQ(seenIn(rawlog()), m_new) << "the next run succeeds";
                EXPECT_EQ(filesIn(now()), m_newFiles) << "and leaves nothing of the one before";
                setUp();
            });
        EXPECT_EQ(results.size(), 2U) << "both outcomes were met";
        return attempts;
    }

 private:
    void setUp() const { copyAll(m_folder.file("begin"), now()); }
    [[nodiscard]] std::string now() const { return m_folder.file("now"); }
    [[nodiscard]] std::string rawlog() const { return now() + "/k.rawlog"; }

    const TemporaryFolder m_folder;
    std::function<void(const std::string& file)> m_replacement;
    std::string m_old, m_new;
    std::set<std::string> m_newFiles;
};

RgbdRawlogWriter::Options embeddedImages()
{
    RgbdRawlogWriter::Options options;
    options.embedImages = true;
    return options;
}

void writeOld(const std::string& file)
{
    write(file, 1.0F, 50, "chair");
}

/** All that can go wrong. */
void checkEverything(Replacing replacing)
{
    EXPECT_GT(replacing.check(Calls::change, KILL), 10U);
    if (canTrace())
        EXPECT_GT(replacing.check(Calls::system, KILL), 40U);
    else
        std::cout << "SKIPPED: kills at each system call, as processes cannot be traced here\n";
    for (const Calls kind : {Calls::open, Calls::write, Calls::sync, Calls::name}) {
        replacing.check(kind, EIO);
        replacing.check(kind, ENOSPC, FOR_GOOD);
    }
}
}  // namespace

TEST(ReplacingARawlog, byOneWithOtherImagesAndPredictions)
{
    checkEverything({writeOld, [](const std::string& file) { write(file, 2.0F, 200, "table"); }});
}

TEST(ReplacingARawlog, byOneWithoutSidecarOrImages)
{
    checkEverything(
        {writeOld, [](const std::string& file) { write(file, 2.0F, 200, "", embeddedImages()); }});
}

TEST(ReplacingARawlog, ofOneWithoutSidecarOrImages)
{
    checkEverything(
        {[](const std::string& file) { write(file, 2.0F, 200, "", embeddedImages()); }, writeOld});
}

TEST(ReplacingARawlog, byItselfWithPredictionsInside)
{
    checkEverything({writeOld, [](const std::string& file) {
                         AddPredictionsOptions options;
                         options.embed = true;
                         const auto source = [](size_t, const auto&) {
                             return makePredictions(
                                 {prediction(rectangleMask(0, 0, 5, 5), "plant", 0.5F)}, 0);
                         };
                         addPredictions(file, source, file, options, [](size_t, double) {});
                     }});
}
