// SPDX-License-Identifier: BSD-3-Clause
#include "PlyVertices.h"

#include "voxeland/base/errors.h"
#include "voxeland/base/numbers.h"
#include "voxeland/base/printable.h"
#include "voxeland/base/trimmed.h"
#include "voxeland/files/InputFile.h"

#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

namespace voxeland
{
namespace
{
constexpr size_t MOST_VERTICES = 50000000;

enum class Type
{
    i8,
    u8,
    i16,
    u16,
    i32,
    u32,
    f32,
    f64
};

struct Property
{
    std::string name;
    Type type = Type::f32;
    std::optional<Type> listSize;  //!< type of the length, where it is a list
};

struct Element
{
    std::string name;
    size_t count = 0;
    std::vector<Property> properties;
};

struct Header
{
    bool ascii = false;
    std::vector<Element> elements;
};

size_t bytesOf(Type type)
{
    switch (type) {
        case Type::i8:
        case Type::u8:
            return 1;
        case Type::i16:
        case Type::u16:
            return 2;
        case Type::f64:
            return 8;
        default:
            return 4;
    }
}

bool isReal(Type type)
{
    return type == Type::f32 || type == Type::f64;
}

/** One file being read. */
class PlyReader
{
 public:
    explicit PlyReader(const std::string& file)
        : m_name(file),
          m_bytes(checkInputFile(file, "the ground truth")),
          m_in(file, std::ios::binary)
    {
        if (!m_in)
            throw InputError("cannot read the ground truth " + file + ": " + std::strerror(errno));
        readHeader();
    }

    std::vector<std::vector<double>> read(const std::vector<PlyColumn>& columns)
    {
        for (const Element& e : m_header.elements) {
            if (e.name == "vertex") return readVertices(e, columns);
            if (e.properties.empty()) continue;  // they may be any number
            for (size_t i = 0; i < e.count; ++i)
                for (const Property& p : e.properties) skip(p);
        }
        fail("has no element 'vertex'");
    }

 private:
    [[noreturn]] void fail(const std::string& what) const
    {
        throw InputError(m_name + " " + what + ".");
    }

    Type typeOf(const std::string& word) const
    {
        static const std::map<std::string, Type> types = {
            {"char", Type::i8},     {"int8", Type::i8},     {"uchar", Type::u8},
            {"uint8", Type::u8},    {"short", Type::i16},   {"int16", Type::i16},
            {"ushort", Type::u16},  {"uint16", Type::u16},  {"int", Type::i32},
            {"int32", Type::i32},   {"uint", Type::u32},    {"uint32", Type::u32},
            {"float", Type::f32},   {"float32", Type::f32}, {"double", Type::f64},
            {"float64", Type::f64},
        };
        const auto at = types.find(word);
        if (at == types.end()) fail("has a property of the unknown type '" + word + "'");
        return at->second;
    }

    void readHeader()
    {
        std::string line, word;
        std::getline(m_in, line);
        if (trimmed(line) != "ply") fail("is not a PLY file");
        while (std::getline(m_in, line)) {
            std::istringstream words(line);
            words >> word;
            if (word == "end_header") return;
            if (word == "format")
                readFormat(words);
            else if (word == "element")
                readElement(words);
            else if (word == "property")
                readProperty(words);
        }
        fail("ends within its header");
    }

    void readFormat(std::istream& words)
    {
        std::string format;
        words >> format;
        m_header.ascii = format == "ascii";
        if (!m_header.ascii && format != "binary_little_endian")
            fail("has the format '" + format + "' instead of ascii or binary_little_endian");
    }

    void readElement(std::istream& words)
    {
        Element e;
        words >> e.name >> m_word;
        const auto count = parsed<size_t>(m_word);
        if (!words || !count) fail("has a malformed element in its header");
        e.count = *count;
        m_header.elements.push_back(std::move(e));
    }

    void readProperty(std::istream& words)
    {
        if (m_header.elements.empty()) fail("has a property before any element");
        Property p;
        std::string type, listSize;
        words >> type;
        if (type == "list") {
            words >> listSize >> type;
            p.listSize = typeOf(listSize);
        }
        p.type = typeOf(type);
        if (!(words >> p.name)) fail("has a property without a name");
        m_header.elements.back().properties.push_back(std::move(p));
    }

    /** Position of a column's property in the element. */
    size_t indexOf(const Element& e, const PlyColumn& column) const
    {
        for (size_t i = 0; i < e.properties.size(); ++i) {
            const Property& p = e.properties[i];
            if (p.name != column.name) continue;
            if (p.listSize) fail("has a list as vertex property '" + p.name + "'");
            if (isReal(p.type) && column.number == PlyNumber::integer)
                fail("must have an integer as vertex property '" + p.name + "'");
            return i;
        }
        fail("has no vertex property '" + column.name + "'");
    }

    std::vector<std::vector<double>> readVertices(const Element& e,
                                                  const std::vector<PlyColumn>& columns)
    {
        std::vector<std::vector<double>*> target(e.properties.size(), nullptr);
        std::vector<std::vector<double>> values(columns.size());
        for (size_t c = 0; c < columns.size(); ++c) target[indexOf(e, columns[c])] = &values[c];
        if (e.count > m_bytes) truncated();  // each vertex takes a byte at least
        if (e.count > MOST_VERTICES)
            fail("has more than " + std::to_string(MOST_VERTICES / 1000000) +
                 " million vertices: reduce the mesh");
        for (auto& v : values) v.reserve(e.count);
        for (size_t i = 0; i < e.count; ++i)
            for (size_t p = 0; p < target.size(); ++p)
                if (target[p] == nullptr)
                    skip(e.properties[p]);
                else
                    target[p]->push_back(number(e.properties[p].type));
        return values;
    }

    void skip(const Property& p)
    {
        const double n = p.listSize ? number(*p.listSize) : 1;
        for (double i = 0; i < n; ++i) number(p.type);
    }

    double number(Type type) { return m_header.ascii ? asciiNumber(type) : binaryNumber(type); }

    double asciiNumber(Type type)
    {
        if (!(m_in >> m_word)) truncated();
        const auto number = parsed<double>(m_word);
        if (!number) fail("has '" + printable(m_word) + "' where a number is expected");
        const double value = *number;
        const bool integer = std::floor(value) == value && std::abs(value) <= UINT32_MAX;
        if (!isReal(type) && !integer)
            fail("has '" + printable(m_word) + "' where an integer of 32 bits is expected");
        return value;
    }

    double binaryNumber(Type type)
    {
        char raw[8];
        if (!m_in.read(raw, static_cast<std::streamsize>(bytesOf(type)))) truncated();
        switch (type) {
            case Type::i8:
                return as<int8_t>(raw);
            case Type::u8:
                return as<uint8_t>(raw);
            case Type::i16:
                return as<int16_t>(raw);
            case Type::u16:
                return as<uint16_t>(raw);
            case Type::i32:
                return as<int32_t>(raw);
            case Type::u32:
                return as<uint32_t>(raw);
            case Type::f32:
                return static_cast<double>(as<float>(raw));
            default:
                return as<double>(raw);
        }
    }

    template <typename T>
    static T as(const char* raw)
    {
        T value;
        std::memcpy(&value, raw, sizeof(T));
        return value;
    }

    [[noreturn]] void truncated() const { fail("is truncated"); }

    std::string m_name;
    uint64_t m_bytes;
    std::ifstream m_in;
    Header m_header;
    std::string m_word;  //!< scratch
};
}  // namespace

std::vector<std::vector<double>> readPlyVertices(const std::string& file,
                                                 const std::vector<PlyColumn>& columns)
{
    return PlyReader(file).read(columns);
}

std::vector<mrpt::math::TPoint3D> pointsOf(const std::vector<std::vector<double>>& columns,
                                           const std::string& file)
{
    const size_t n = columns[0].size();
    if (n == 0) throw InputError(file + " holds no vertices.");
    std::vector<mrpt::math::TPoint3D> points;
    points.reserve(n);
    for (size_t i = 0; i < n; ++i) {
        const mrpt::math::TPoint3D p(columns[0][i], columns[1][i], columns[2][i]);
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
            throw InputError("vertex " + std::to_string(i) + " of " + file +
                             " has no finite coordinates.");
        points.emplace_back(p);
    }
    return points;
}
}  // namespace voxeland
