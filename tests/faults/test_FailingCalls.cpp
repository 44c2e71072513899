// SPDX-License-Identifier: BSD-3-Clause
/** Mapping, saving, exporting and asking, in which any call may fail: each run ends with success or
 * a sentence, and leaves the old output or the new one. */
#include "Attempts.h"
#include "disambiguation/AnswerJournal.h"
#include "disambiguation/Revision.h"
#include "pictures/MapViews.h"
#include "rawlogs/StagedRawlog.h"
#include "support/RunProgram.h"
#include "support/SevenScenes.h"
#include "support/SmallRawlog.h"
#include "support/TestFiles.h"
#include "voxeland/datasets/RgbdDatasetReader.h"
#include "voxeland/exporters/Exporter.h"
#include "voxeland/level/UpDirection.h"
#include "voxeland/metric_map/MapFile.h"
#include "voxeland/metric_map/RawlogMapping.h"
#include "voxeland/rawlogs/RgbdRawlogWriter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <map>

using namespace voxeland;
using namespace voxeland::test;
namespace fs = std::filesystem;

namespace
{
constexpr unsigned EVERY = 1000;  // attempts, where there are fewer calls

/** All files below a folder, with their content. */
using Content = std::map<std::string, std::string>;

Content contentOf(const fs::path& folder)
{
    Content content;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            content[fs::relative(entry.path(), folder)] = readFile(entry.path());
    return content;
}

/** A folder of outputs, and what each may be after a run that some call failed in. */
class Outputs
{
 public:
    Outputs() { fs::create_directory(path()); }

    [[nodiscard]] std::string path() const { return m_folder.file("out"); }
    [[nodiscard]] std::string file(const std::string& name) const { return path() + "/" + name; }

    void rememberOld() { m_old = contentOf(path()); }
    void rememberNew() { m_new = contentOf(path()); }
    void reset() const
    {
        fs::remove_all(path());
        for (const auto& [name, content] : m_old) {
            fs::create_directories(fs::path(file(name)).parent_path());
            writeFile(file(name), content);
        }
    }
    /** \param cutShort parts of the run may be left */
    void check(bool complete, bool cutShort) const
    {
        finishReplacing(RawlogFiles(file("a.rawlog")));
        for (const auto& [name, content] : contentOf(path())) {
            if (cutShort && name.find(".part") != std::string::npos) continue;
            if (fs::path(name).extension() == ".answers") continue;
            const auto before = m_old.find(name), after = m_new.find(name);
            EXPECT_TRUE((before != m_old.end() && before->second == content) ||
                        (after != m_new.end() && after->second == content))
                << name << " of " << content.size() << " bytes is neither old nor new";
        }
        for (const auto& [name, content] : m_new)
            EXPECT_TRUE(!complete || readFile(file(name)) == content) << name << " is not new";
    }

 private:
    const TemporaryFolder m_folder;
    Content m_old, m_new;
};

/** A rawlog, its map, and another map in whose place that goes. */
class FailingCalls : public testing::Test
{
 protected:
    void SetUp() override
    {
        writeWithImages(m_rawlog, smallFrames(4));
        mapTo(m_map, "");
        mapTo(m_outputs.file("a.voxeland"), "0.1");
        m_outputs.rememberOld();
    }

    /** Depth in files of its own. */
    static void writeWithImages(const std::string& file, const std::vector<SmallFrame>& frames)
    {
        RgbdRawlogWriter writer(file, {});
        for (const SmallFrame& f : frames) {
            RgbdRecord record;
            record.scan = f.scan;
            record.robotPose = std::make_shared<mrpt::math::TPose3D>(f.pose->pose.mean.asTPose());
            record.instances = f.instances;
            writer.write(record);
        }
        writer.close();
    }

    /** \param strict a frame that cannot be read is an error */
    void mapTo(const std::string& file, const std::string& resolution, int threads = 2,
               bool strict = true) const
    {
        Ini ini = Ini::fromText("", "test");
        ini.set("voxeland.threads=" + std::to_string(threads), "test");
        ini.set("refinement.every=2", "test");
        if (!resolution.empty()) ini.set("map.resolution=" + resolution, "test");
        CVoxelandMap map{MapperConfig(ini)};
        RawlogFrameSource source(m_rawlog, map.mapper().config().input, {});
        mapRawlog(
            source, map, [](const StageTimes&) {}, strict);
        saveMap(map, file);
    }

    /** One sentence, as a person reads it. */
    static void expectSentence(const std::string& message)
    {
        EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << message;
        EXPECT_LT(message.size(), 300U) << message;
        for (const char* jargon :
             {"std::", "bad_alloc", "terminate", ".cpp", "OpenCV", "exception"})
            EXPECT_EQ(message.find(jargon), std::string::npos) << message;
    }

    /** \param most attempts */
    void check(const std::function<void()>& work, Calls kind, int error, unsigned times,
               unsigned most)
    {
        m_outputs.reset();
        attemptAll(kind, error, times, most, work, [&](const Attempt& end) {
            SCOPED_TRACE("call " + std::to_string(end.call) + " of kind " +
                         std::to_string(static_cast<int>(kind)) + " " + end.message);
            const bool killed = end.signal != 0;
            EXPECT_TRUE(error == KILL ? !killed || end.signal == SIGKILL : !killed) << end.signal;
            EXPECT_LE(end.exitCode, 5);
            if (end.exitCode > 0) expectSentence(end.message);
            // Where memory ends in a function that must not throw, nothing is cleaned up.
            const bool cutShort = end.message.find("attempt: ") == std::string::npos;
            m_outputs.check(end.exitCode == 0, cutShort);
            m_outputs.reset();
        });
    }

    /** Killed before any system call. What follows succeeds, and cleans up. */
    void checkKilled(const std::function<void()>& work, unsigned most)
    {
        m_outputs.reset();
        work();
        m_outputs.rememberNew();
        m_outputs.reset();
        unsigned killed = 0;
        attemptAll(Calls::system, KILL, ONCE, most, work, [&](const Attempt& end) {
            SCOPED_TRACE("system call " + std::to_string(end.call) + " " + end.message);
            EXPECT_TRUE(end.signal == SIGKILL || end.exitCode == 0) << end.exitCode;
            killed += end.signal == SIGKILL ? 1 : 0;
            m_outputs.check(end.exitCode == 0, true);
            work();
            m_outputs.check(true, false);
            m_outputs.reset();
        });
        EXPECT_GT(killed, 15U);
    }

    /** Calls that have to do with files. \param most attempts of each way to fail */
    void checkFiles(const std::function<void()>& work, unsigned most = 40)
    {
        work();
        m_outputs.rememberNew();
        check(work, Calls::change, KILL, ONCE, most);
        check(work, Calls::write, ENOSPC, FOR_GOOD, most / 2);
        for (const Calls kind : {Calls::open, Calls::read, Calls::sync, Calls::name})
            check(work, kind, EIO, ONCE, most / 2);
    }
    void checkAll(const std::function<void()>& work, unsigned most = 40)
    {
        checkFiles(work, most);
        check(work, Calls::memory, ENOMEM, ONCE, 2 * most);
    }

    const TemporaryFolder m_folder;
    Outputs m_outputs;
    const std::string m_rawlog = m_folder.file("in.rawlog"), m_map = m_folder.file("in.voxeland");
};
}  // namespace

TEST_F(FailingCalls, Mapping)
{
    checkFiles([this] { mapTo(m_outputs.file("a.voxeland"), ""); });
}

TEST_F(FailingCalls, MappingWithoutMemory)
{
    for (const int threads : {1, 2}) {
        const auto map = [&] { mapTo(m_outputs.file("a.voxeland"), "", threads, false); };
        map();
        m_outputs.rememberNew();
        check(map, Calls::memory, ENOMEM, ONCE, 100);
    }
}

/** PNG and JPEG pictures become a rawlog. */
TEST_F(FailingCalls, ConvertingWithoutMemory)
{
    const std::string dataset = m_folder.file("dataset");
    writeSevenScenesFrame(dataset + "/seq-01/frame-000000", "png");
    writeSevenScenesFrame(dataset + "/seq-01/frame-000001", "jpg");
    const auto convert = [&] {
        const auto reader = openDataset("7scenes", dataset, {});
        RgbdRawlogWriter writer(m_outputs.file("a.rawlog"), {});
        for (RgbdRecord record; reader->next(record);) writer.write(record);
        writer.close();
    };
    convert();
    m_outputs.rememberNew();
    check(convert, Calls::memory, ENOMEM, ONCE, 100);
}

TEST_F(FailingCalls, LoadingAndSaving)
{
    checkAll([this] { saveMap(*loadMap(m_map), m_outputs.file("a.voxeland")); });
}

#define SKIP_UNLESS_TRACING() \
    if (!canTrace()) GTEST_SKIP() << "processes cannot be traced here"

TEST_F(FailingCalls, SavingIsKilled)
{
    SKIP_UNLESS_TRACING();
    const auto map = loadMap(m_map);
    checkKilled([&] { saveMap(*map, m_outputs.file("a.voxeland")); }, EVERY);
}

/** Every format, in a file or folder of its own. */
class FailingExports : public FailingCalls
{
 protected:
    void SetUp() override
    {
        FailingCalls::SetUp();
        mapTo(m_map, "0.2");
    }

    void exportAllFormats(const SemanticVoxelMap& map) const
    {
        ExportSettings settings;
        settings.frame = GravityAlignedFrame(estimateUp(map));
        settings.heights = HeightRange{-1, 3};
        WrittenFiles written;
        for (const Exporter& e : exporters())
            if (e.name != "png-dir")  // which takes longer than all others
                e.write(map, settings,
                        m_outputs.file(e.name + (e.endings.empty() ? "" : e.endings.front())),
                        written);
    }
};

TEST_F(FailingExports, EndInASentence)
{
    checkAll([this] { exportAllFormats(loadMap(m_map)->map()); }, 10);
}

TEST_F(FailingExports, OfPicturesEndInASentence)
{
    const auto map = loadMap(m_map);
    checkAll(
        [&] {
            WrittenFiles written;
            exportViews(map->map(), m_outputs.path(), written, {});
        },
        2);
}

TEST_F(FailingExports, AreKilled)
{
    SKIP_UNLESS_TRACING();
    const auto map = loadMap(m_map);
    checkKilled([&] { exportAllFormats(map->map()); }, 100);
}

/** An answer about each object, kept until the map is written. */
class FailingAnswers : public FailingCalls
{
 protected:
    void ask() const
    {
        const std::string output = m_outputs.file("a.voxeland");
        const auto map = loadMap(m_map);
        const Revision revision(map->map(), "Backend");
        AnswerJournal journal(output, m_map, "Backend");
        const auto decide = [&](instance_id_t id, const Decision& d) {
            revision.decide(map->editMap(), id, d, DisambiguationOptions());
        };
        journal.replay(map->map(), decide);
        for (const auto& [id, instance] : map->map().instances()) {
            Decision decision;
            decision.source = "Backend";
            decision.answer = "none of them";
            decide(id, decision);
            journal.add(id, map->map().instance(id).decisions.back());
        }
        saveMap(*map, output);
        journal.discard();
    }
};

TEST_F(FailingAnswers, EndInASentence)
{
    checkAll([this] { ask(); });
}

TEST_F(FailingAnswers, AreKilled)
{
    SKIP_UNLESS_TRACING();
    checkKilled([this] { ask(); }, EVERY);
}
