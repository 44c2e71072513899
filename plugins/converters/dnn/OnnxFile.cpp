// SPDX-License-Identifier: BSD-3-Clause
#include "OnnxFile.h"

#include "ProtobufFields.h"
#include "voxeland/errors.h"

#include <fstream>
#include <iterator>
#include <optional>
#include <regex>

namespace voxeland
{
namespace
{
/** Content of the first field of this number. */
std::optional<std::string_view> find(std::string_view message, uint64_t number)
{
    for (ProtobufFields fields(message); fields.next();)
        if (fields.number() == number) return fields.content();
    return std::nullopt;
}

/** Content of a field of a field of ... of a message; empty if there is none. */
std::string_view find(std::string_view message, std::initializer_list<uint64_t> path)
{
    for (const uint64_t number : path) message = find(message, number).value_or("");
    return message;
}

// Numbers of the fields, from onnx.proto.
constexpr uint64_t MODEL_GRAPH = 7, MODEL_METADATA = 14, METADATA_KEY = 1, METADATA_VALUE = 2;
constexpr uint64_t GRAPH_INPUT = 11, INPUT_TYPE = 2, TYPE_TENSOR = 1, TENSOR_SHAPE = 2;
constexpr uint64_t SHAPE_DIMENSION = 1, DIMENSION_VALUE = 1;

/** Width and height of the first input, which is batch x channels x height x width. */
cv::Size inputSize(std::string_view graph)
{
    const auto shape = find(graph, {GRAPH_INPUT, INPUT_TYPE, TYPE_TENSOR, TENSOR_SHAPE});
    std::vector<int> sizes;
    for (ProtobufFields fields(shape); fields.next();) {
        if (fields.number() != SHAPE_DIMENSION) continue;
        int size = 0;
        for (ProtobufFields dimension(fields.content()); dimension.next();)
            if (dimension.number() == DIMENSION_VALUE) size = static_cast<int>(dimension.integer());
        sizes.push_back(size);
    }
    if (sizes.size() != 4 || sizes[2] <= 0 || sizes[3] <= 0) return {};
    return {sizes[3], sizes[2]};
}

/** Names from a Python dictionary such as {0: 'person', 1: "bull's eye"}; empty if it is none. */
std::vector<std::string> namesFromDictionary(const std::string& text)
{
    static const std::regex ENTRY(R"re((\d+): (?:'([^']*)'|"([^"]*)"))re");
    std::vector<std::string> names;
    for (std::sregex_iterator at(text.begin(), text.end(), ENTRY), end; at != end; ++at) {
        if (at->str(1) != std::to_string(names.size())) return {};
        names.push_back(at->str(2) + at->str(3));
    }
    return names;
}
}  // namespace

OnnxFile::OnnxFile(const std::string& file)
{
    std::ifstream in(file, std::ios::binary);
    if (!in) throw InputError("cannot open the model '" + file + "'");
    bytes.assign(std::istreambuf_iterator<char>(in), {});
    const std::string_view model(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    try {
        const auto graph = find(model, MODEL_GRAPH);
        if (!graph) throw std::invalid_argument("no graph");
        input = inputSize(*graph);
        for (ProtobufFields fields(model); fields.next();)
            if (fields.number() == MODEL_METADATA &&
                find(fields.content(), METADATA_KEY) == "names")
                classNames = namesFromDictionary(
                    std::string(find(fields.content(), METADATA_VALUE).value_or("")));
    } catch (const ProtobufFields::CutOff&) {
        throw InputError("the model '" + file + "' is cut off: copy or export it again");
    } catch (const std::invalid_argument&) {
        throw InputError("'" + file + "' is not an ONNX model");
    }
}
}  // namespace voxeland
