// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <opencv2/core/types.hpp>

#include <string>
#include <vector>

namespace voxeland
{
/** What an ONNX model says of itself that OpenCV does not pass on. */
struct OnnxFile
{
    std::vector<uint8_t> bytes;           //!< the whole file, for OpenCV to parse
    cv::Size input;                       //!< of the first input; 0x0 if any size goes [pixels]
    std::vector<std::string> classNames;  //!< as Ultralytics' exports have them; empty: none given
    /** Options of Ultralytics' export that would make it easier to read, such as "half=False": if
     * OpenCV cannot use the model, what they concern is the likely reason. */
    std::vector<std::string> exportOptions;

    /** \throws InputError, naming the file, if it is missing, cut off, something else or only a
     * part of a model whose weights are in other files */
    explicit OnnxFile(const std::string& file);
};
}  // namespace voxeland
