// SPDX-License-Identifier: BSD-3-Clause
#include "DatasetFiles.h"

#include "OpticalPose.h"
#include "voxeland/base/RefusedMemory.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/numbers.h"
#include "voxeland/datasets/RgbdDatasetReader.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
constexpr int64_t FRAMES_PER_SECOND = 30;

bool isFinite(double value)
{
    return std::isfinite(value);
}
}  // namespace

bool readNumber(std::istream& in, double& number)
{
    std::string word;  // operator>> for numbers does not know "nan" and "inf"
    if (!(in >> word)) return false;
    const auto value = parsed<double>(word);
    number = value.value_or(0);
    return value.has_value();
}

std::vector<double> readNumbers(const fs::path& file)
{
    std::ifstream in;
    errno = 0;
    if (fs::is_regular_file(file)) in.open(file);
    if (!in.is_open()) RefusedMemory::noteErrno();
    std::vector<double> numbers;
    for (double number = 0; readNumber(in, number);) numbers.push_back(number);
    return numbers;
}

std::shared_ptr<mrpt::math::TPose3D> poseFromNumbers(const std::vector<double>& matrix)
{
    std::array<double, 16> m{};
    if (matrix.size() != m.size()) throw UnusableFrame("pose is not a 4x4 matrix");
    if (!std::all_of(matrix.begin(), matrix.end(), isFinite))
        throw UnusableFrame("pose is not finite");
    std::copy(matrix.begin(), matrix.end(), m.begin());
    const auto pose = poseFromOptical(m);
    if (!pose) throw UnusableFrame("pose is not a rigid transform");
    return std::make_shared<mrpt::math::TPose3D>(*pose);
}

PinholeCamera readCameraMatrix(const fs::path& file)
{
    const auto k = readNumbers(file);
    const size_t columns = k.size() == 16 ? 4 : 3;
    if (k.size() != columns * columns || !std::all_of(k.begin(), k.end(), isFinite) || k[0] <= 0 ||
        k[columns + 1] <= 0)
        throw InputError(file.string() + " is not a 3x3 or 4x4 matrix of camera intrinsics");
    return {k[0], k[columns + 1], k[2], k[columns + 2], {}};
}

std::vector<fs::path> entriesOf(const fs::path& folder)
{
    std::vector<fs::path> entries;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().filename().string().front() != '.') entries.push_back(entry.path());
    std::sort(entries.begin(), entries.end());
    return entries;
}

std::map<int64_t, fs::path> numberedFiles(const fs::path& folder, const std::regex& pattern)
{
    std::map<int64_t, fs::path> files;
    if (!fs::is_directory(folder)) return files;
    for (const fs::path& entry : entriesOf(folder)) {
        const std::string name = entry.filename().string();
        std::smatch match;
        if (std::regex_match(name, match, pattern)) files.emplace(std::stoll(match[1]), entry);
    }
    return files;
}

mrpt::Clock::time_point timeOfFrame(double start, int64_t number)
{
    constexpr auto TICKS = mrpt::Clock::period::den;
    const auto ticks =
        number / FRAMES_PER_SECOND * TICKS + number % FRAMES_PER_SECOND * TICKS / FRAMES_PER_SECOND;
    return mrpt::Clock::fromDouble(start) + mrpt::Clock::duration(ticks);
}

void checkFolder(const std::string& folder)
{
    if (fs::is_regular_file(folder))
        throw InputError(folder + " is a file: give the folder of the dataset that it belongs to");
    if (!fs::is_directory(folder)) throw InputError("there is no folder " + folder);
}
}  // namespace voxeland
