// SPDX-License-Identifier: BSD-3-Clause
#include "support/SmallRawlog.h"

#include "files/GzOutputFile.h"
#include "rawlogs/RawlogFiles.h"

#include <cmath>

namespace voxeland::test
{
std::vector<SmallFrame> smallFrames(int count)
{
    std::vector<SmallFrame> frames;
    for (int i = 0; i < count; ++i) {
        const double seconds = 1000 + 0.1 * i;
        const int left = 25 + i % 7, top = 18 + i % 5;
        const auto onBox = [=](int c, int r) {
            return c >= left && c < left + 20 && r >= top && r < top + 20;
        };
        SmallFrame f;
        f.scan = makeScan(
            [&](int c, int r) { return onBox(c, r) ? 1.5 + 0.002 * c : 2.6 + 0.003 * r; }, seconds);
        f.instances = makePredictions({prediction(rectangleMask(left, top, left + 20, top + 20),
                                                  i % 3 == 0 ? "box" : "tv", 0.8F),
                                       prediction(rectangleMask(60, 5, 78, 25), "picture", 0.6F)},
                                      seconds);
        f.pose = std::make_shared<mrpt::obs::CObservationRobotPose>();
        f.pose->timestamp = f.scan->timestamp;
        f.pose->pose.mean =
            mrpt::poses::CPose3D(0.01 * i, -0.02 * i, 1 + 0.003 * i, 0.01 * i, 0.002 * i, 0);
        frames.push_back(f);
    }
    return frames;
}

void writeRawlog(const std::string& file, const std::vector<SmallFrame>& frames, bool embed)
{
    GzOutputFile rawlog(file);
    std::unique_ptr<GzOutputFile> sidecar;
    if (!embed) sidecar = std::make_unique<GzOutputFile>(RawlogFiles(file).sidecar.string());
    for (const SmallFrame& f : frames) {
        if (f.pose) rawlog.writeObject(*f.pose);
        if (f.instances) (embed ? rawlog : *sidecar).writeObject(*f.instances);
        if (f.scan) rawlog.writeObject(*f.scan);
    }
    rawlog.close();
    if (sidecar) sidecar->close();
}
}  // namespace voxeland::test
