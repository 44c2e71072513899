// SPDX-License-Identifier: BSD-3-Clause
/** Writes small files of the binary formats, for fuzzers to begin with: `make_seeds FOLDER`. */
#include "files/GzOutputFile.h"
#include "plugins/dnn/SmallOnnx.h"
#include "rawlogs/RawlogFiles.h"
#include "support/MapBytes.h"
#include "support/ScanNetScene.h"
#include "support/SmallRawlog.h"
#include "support/TestFiles.h"
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/MapFile.h"
#include "voxeland/metric_map/RawlogMapping.h"

#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <zlib.h>

using namespace voxeland;
using namespace voxeland::test;
namespace fs = std::filesystem;

namespace
{
std::string uncompressed(const std::string& file)
{
    std::string content, buffer(1 << 16, '\0');
    const gzFile in = gzopen(file.c_str(), "rb");
    for (int n = 0; (n = gzread(in, buffer.data(), static_cast<unsigned>(buffer.size()))) > 0;)
        content.append(buffer, 0, static_cast<size_t>(n));
    gzclose(in);
    return content;
}

void write(const fs::path& file, const std::string& content)
{
    fs::create_directories(file.parent_path());
    writeFile(file, content);
}

void writeMap(const std::string& rawlog, const std::string& file)
{
    const MapperConfig config(Ini::fromText("[map]\nresolution = 0.2\n", "seed"));
    CVoxelandMap map(config);
    RawlogFrameSource source(rawlog, config.input, {});
    mapRawlog(source, map, [](const StageTimes&) {});
    saveMap(map, file);
}

/** Keyframes with colours, as cameras of robots have them. */
void writeSimplemap(const std::string& file)
{
    mrpt::maps::CSimpleMap map;
    for (const SmallFrame& frame : smallFrames(2)) {
        frame.scan->hasIntensityImage = true;
        frame.scan->intensityImage = mrpt::img::CImage(COLUMNS, ROWS, mrpt::img::CH_RGB);
        frame.scan->intensityImage.filledRectangle(0, 0, COLUMNS / 2, ROWS, {200, 100, 50});
        const auto sensed = mrpt::obs::CSensoryFrame::Create();
        sensed->insert(frame.scan);
        sensed->insert(frame.instances);
        map.insert(mrpt::poses::CPose3DPDFGaussian::Create(frame.pose->pose), sensed);
    }
    GzOutputFile out(file);
    out.writeObject(map);
    out.close();
}
}  // namespace

int main(int argc, char** argv)
{
    if (argc != 2) return 1;
    const fs::path seeds = argv[1];
    const TemporaryFolder folder;
    const std::string rawlog = folder.file("in.rawlog");
    writeRawlog(rawlog, smallFrames(2));
    write(seeds / "sidecar" / "two_frames", uncompressed(RawlogFiles(rawlog).sidecar.string()));
    writeMap(rawlog, folder.file("seed.voxeland"));
    write(seeds / "map" / "two_frames", uncompressed(folder.file("seed.voxeland")));
    writeRawlog(rawlog, smallFrames(2), true);
    write(seeds / "rawlog" / "two_frames", uncompressed(rawlog));
    writeSimplemap(rawlog);
    write(seeds / "rawlog" / "simplemap", uncompressed(rawlog));
    write(seeds / "sens" / "two_frames",
          ScanNetScene::sensFile({ScanNetScene::sensFrame(0), ScanNetScene::sensFrame(1)}));
    write(seeds / "onnx" / "yolo",
          smallOnnx({{"Add", {"x", "c"}, {"y"}}}, {1, 3, 640, 640}, "{0: 'person', 1: \"cup\"}"));
    return 0;
}
