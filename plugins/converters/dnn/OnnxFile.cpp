// SPDX-License-Identifier: BSD-3-Clause
#include "OnnxFile.h"

#include "ProtobufFields.h"
#include "voxeland/base/errors.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>

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
constexpr uint64_t GRAPH_NODE = 1, GRAPH_INITIALIZER = 5, GRAPH_INPUT = 11, NODE_OPERATION = 4;
constexpr uint64_t INPUT_TYPE = 2, TYPE_TENSOR = 1, TENSOR_SHAPE = 2;
constexpr uint64_t SHAPE_DIMENSION = 1, DIMENSION_VALUE = 1;
constexpr uint64_t INITIALIZER_TYPE = 2, INITIALIZER_LOCATION = 14;
// Values of some, likewise.
constexpr uint64_t FLOAT16 = 10, EXTERNAL = 1;

/** Value of the first field of this number; 0 if there is none. */
uint64_t integer(std::string_view message, uint64_t number)
{
    for (ProtobufFields fields(message); fields.next();)
        if (fields.number() == number) return fields.integer();
    return 0;
}

/** Sizes of the first input, which is batch x channels x height x width; 0: any. */
std::vector<int> inputShape(std::string_view graph)
{
    const auto shape = find(graph, {GRAPH_INPUT, INPUT_TYPE, TYPE_TENSOR, TENSOR_SHAPE});
    std::vector<int> sizes;
    for (ProtobufFields fields(shape); fields.next();)
        if (fields.number() == SHAPE_DIMENSION)
            sizes.push_back(static_cast<int>(integer(fields.content(), DIMENSION_VALUE)));
    return sizes;
}

cv::Size imageSize(const std::vector<int>& shape)
{
    if (shape.size() != 4 || shape[2] <= 0 || shape[3] <= 0) return {};
    return {shape[3], shape[2]};
}

/** Whether the weights are in another file. */
bool isExternal(std::string_view graph)
{
    for (ProtobufFields fields(graph); fields.next();)
        if (fields.number() == GRAPH_INITIALIZER &&
            integer(fields.content(), INITIALIZER_LOCATION) == EXTERNAL)
            return true;
    return false;
}

/** See OnnxFile::exportOptions. */
std::vector<std::string> optionsFor(std::string_view graph, const std::vector<int>& shape)
{
    bool sorts = false, isHalf = false, isQuantized = false;
    for (ProtobufFields fields(graph); fields.next();) {
        if (fields.number() == GRAPH_NODE) {
            const std::string_view operation = find(fields.content(), NODE_OPERATION).value_or("");
            sorts = sorts || operation == "TopK" || operation == "NonMaxSuppression";
            isQuantized = isQuantized || operation.find("uantize") != std::string_view::npos ||
                          operation.substr(0, 7) == "QLinear";
        } else if (fields.number() == GRAPH_INITIALIZER) {
            isHalf = isHalf || integer(fields.content(), INITIALIZER_TYPE) == FLOAT16;
        }
    }
    std::vector<std::string> options;
    if (sorts) options.insert(options.end(), {"nms=False", "end2end=False"});
    if (isHalf) options.emplace_back("half=False");
    if (isQuantized) options.emplace_back("int8=False");
    if (std::count(shape.begin(), shape.end(), 0) > 0) options.emplace_back("dynamic=False");
    if (!shape.empty() && shape.front() > 1) options.emplace_back("batch=1");
    return options;
}

/** Reads names from a dictionary of Python or JSON such as {0: 'person', 1: "bull's eye"}, or a
 *  list of such. */
class NameList
{
 public:
    explicit NameList(std::string_view text) : m_rest(text) {}

    /** Empty if it is neither, or out of order, or has no end. */
    std::vector<std::string> names()
    {
        const bool isList = taken('[');
        if (!isList && !taken('{')) return {};
        std::vector<std::string> names;
        while (!taken(isList ? ']' : '}')) {
            if (!isList && (key() != std::to_string(names.size()) || !taken(':'))) return {};
            auto name = quoted();
            if (!name) return {};
            names.push_back(std::move(*name));
            taken(',');
        }
        return names;
    }

 private:
    bool taken(char c)
    {
        m_rest.remove_prefix(std::min(m_rest.find_first_not_of(" \t\n"), m_rest.size()));
        if (m_rest.empty() || m_rest.front() != c) return false;
        m_rest.remove_prefix(1);
        return true;
    }
    std::optional<std::string> upTo(size_t end)
    {
        if (end == std::string_view::npos) return std::nullopt;
        std::string text(m_rest.substr(0, end));
        m_rest.remove_prefix(end);
        return text;
    }
    std::optional<std::string> quoted()
    {
        for (const char quote : {'\'', '"'})
            if (taken(quote)) {
                auto text = upTo(m_rest.find(quote));
                taken(quote);
                return text;
            }
        return std::nullopt;
    }
    std::optional<std::string> key()
    {
        auto text = quoted();
        return text ? text : upTo(m_rest.find_first_not_of("0123456789"));
    }

    std::string_view m_rest;
};
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
        if (isExternal(*graph))
            throw InputError("the weights of the model '" + file +
                             "' are in another file, which OpenCV does not read: save it as one "
                             "file, in Python onnx.save(onnx.load('" +
                             std::filesystem::path(file).filename().string() +
                             "'), 'one_file.onnx')");
        const auto shape = inputShape(*graph);
        input = imageSize(shape);
        exportOptions = optionsFor(*graph, shape);
        for (ProtobufFields fields(model); fields.next();)
            if (fields.number() == MODEL_METADATA &&
                find(fields.content(), METADATA_KEY) == "names")
                classNames = NameList(find(fields.content(), METADATA_VALUE).value_or("")).names();
    } catch (const ProtobufFields::CutOff&) {
        throw InputError("the model '" + file + "' is cut off: copy or export it again");
    } catch (const std::invalid_argument&) {
        throw InputError("'" + file + "' is not an ONNX model");
    }
}
}  // namespace voxeland
