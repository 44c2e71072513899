// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace voxeland::test
{
/** A step of a small ONNX model: its operation, and the tensors it reads and writes. */
struct OnnxNode
{
    std::string operation;
    std::vector<std::string> inputs, outputs;
};

/** Types of an ONNX model's numbers. */
constexpr size_t ONNX_FLOAT = 1, ONNX_FLOAT16 = 10;

/** The constant "c" of a small ONNX model, of zeros. */
struct OnnxConstant
{
    std::vector<int> shape = {1};
    size_t type = ONNX_FLOAT;
    bool isExternal = false;  //!< whether it only names another file
};

/** The bytes of an ONNX model with an input "x" of float, a constant "c" of zeros and a result "y".
 *  \param inputShape sizes; 0 stands for one that is not given
 *  \param names value of the metadata "names"; empty: no metadata */
std::string smallOnnx(const std::vector<OnnxNode>& nodes, const std::vector<int>& inputShape,
                      const std::string& names = "", const OnnxConstant& constant = {});
}  // namespace voxeland::test
