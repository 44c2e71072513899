// SPDX-License-Identifier: BSD-3-Clause
#include "SmallOnnx.h"

namespace voxeland::test
{
namespace
{
std::string varint(size_t value)
{
    std::string bytes;
    for (; value >= 0x80; value >>= 7) bytes += static_cast<char>(value | 0x80);
    return bytes + static_cast<char>(value);
}

std::string integer(size_t field, size_t value)
{
    return varint(field << 3) + varint(value);
}

std::string part(size_t field, const std::string& content)
{
    return varint(field << 3 | 2) + varint(content.size()) + content;
}

/** A TensorProto. */
std::string zeros(const std::string& name, const OnnxConstant& constant)
{
    std::string dimensions;
    size_t bytes = constant.type == ONNX_FLOAT16 ? sizeof(float) / 2 : sizeof(float);
    for (const int size : constant.shape) {
        dimensions += integer(1, static_cast<size_t>(size));
        bytes *= static_cast<size_t>(size);
    }
    const std::string values =
        constant.isExternal
            ? part(13, part(1, "location") + part(2, "weights.data")) + integer(14, 1)
            : part(9, std::string(bytes, '\0'));
    return dimensions + integer(2, constant.type) + part(8, name) + values;
}

/** A ValueInfoProto. */
std::string tensor(const std::string& name, const std::vector<int>& shape)
{
    std::string dimensions;
    for (const int size : shape)
        dimensions += part(1, size == 0 ? part(2, "any") : integer(1, static_cast<size_t>(size)));
    return part(1, name) + part(2, part(1, integer(1, ONNX_FLOAT) + part(2, dimensions)));
}
}  // namespace

std::string smallOnnx(const std::vector<OnnxNode>& nodes, const std::vector<int>& inputShape,
                      const std::string& names, const OnnxConstant& constant)
{
    std::string graph;
    for (const OnnxNode& n : nodes) {
        std::string node;
        for (const auto& name : n.inputs) node += part(1, name);
        for (const auto& name : n.outputs) node += part(2, name);
        graph += part(1, node + part(3, n.operation + "_node") + part(4, n.operation));
    }
    graph += part(2, "graph") + part(5, zeros("c", constant)) + part(11, tensor("x", inputShape)) +
             part(12, tensor("y", inputShape));
    const std::string metadata = names.empty() ? "" : part(14, part(1, "names") + part(2, names));
    constexpr size_t IR_VERSION = 7, OPSET = 12;
    return integer(1, IR_VERSION) + part(7, graph) + part(8, integer(2, OPSET)) + metadata;
}
}  // namespace voxeland::test
