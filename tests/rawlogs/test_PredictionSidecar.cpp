// SPDX-License-Identifier: BSD-3-Clause
/** All predictions of a sidecar come, each when its time has come. */
#include "support/Frames.h"
#include "support/TestFiles.h"
#include "voxeland/errors.h"
#include "voxeland/io/GzOutputFile.h"
#include "voxeland/rawlogs/PredictionSidecar.h"
#include "voxeland/rawlogs/RawlogFiles.h"

#include <gtest/gtest.h>

using namespace voxeland;
using namespace voxeland::test;

namespace
{
/** Predictions of no instances. \param detector sensor label */
std::shared_ptr<CObservationInstances> from(const std::string& detector, double seconds)
{
    auto predictions = makePredictions({}, seconds);
    predictions->sensorLabel = detector;
    return predictions;
}

class ASidecar : public testing::Test
{
 protected:
    void SetUp() override
    {
        GzOutputFile out(m_files.sidecar.string());
        for (const auto& predictions :
             {from("yolo", 1), from("mask2former", 1), from("yolo", 2), from("yolo", 3)})
            out.writeObject(*predictions);
        out.close();
    }

    /** How many predictions come until a time. */
    static int count(PredictionSidecar& sidecar, double seconds)
    {
        int found = 0;
        while (sidecar.next(mrpt::Clock::fromDouble(seconds))) ++found;
        return found;
    }

    TemporaryFolder m_folder;
    RawlogFiles m_files{m_folder.file("in.rawlog")};
};
}  // namespace

TEST_F(ASidecar, GivesThePredictionsOfEveryDetector)
{
    PredictionSidecar sidecar(m_files);
    const auto one = mrpt::Clock::fromDouble(1);
    EXPECT_EQ(sidecar.next(one)->sensorLabel, "yolo");
    EXPECT_EQ(sidecar.next(one)->sensorLabel, "mask2former");
    EXPECT_EQ(sidecar.next(one), nullptr);
}

TEST_F(ASidecar, KeepsWhatIsLaterThanAskedFor)
{
    PredictionSidecar sidecar(m_files);
    EXPECT_EQ(count(sidecar, 0.5), 0);
    EXPECT_EQ(count(sidecar, 2.5), 3);
    EXPECT_EQ(count(sidecar, 1), 0) << "they have been given";
    EXPECT_EQ(count(sidecar, 9), 1);
    EXPECT_EQ(count(sidecar, 9), 0);
}

TEST_F(ASidecar, NeedNotBeThere)
{
    PredictionSidecar none{RawlogFiles(m_folder.file("other.rawlog"))};
    EXPECT_EQ(count(none, 9), 0);
}

TEST_F(ASidecar, ThatIsCutOffIsTold)
{
    const std::string whole = readFile(m_files.sidecar.string());
    writeFile(m_files.sidecar.string(), whole.substr(0, whole.size() / 2));
    PredictionSidecar sidecar(m_files);
    EXPECT_THROW(count(sidecar, 9), InputError);
}
