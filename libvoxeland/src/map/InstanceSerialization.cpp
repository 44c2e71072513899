// SPDX-License-Identifier: BSD-3-Clause
#include "InstanceSerialization.h"

#include "base/Reading.h"

#include <mrpt/serialization/stl_serialization.h>

#include <cstdlib>
#include <utility>

using mrpt::serialization::CArchive;

namespace voxeland
{
namespace
{
void write(CArchive& out, const mrpt::math::TPoint3Df& p)
{
    out << p.x << p.y << p.z;
}

mrpt::math::TPoint3Df readPoint(CArchive& in)
{
    mrpt::math::TPoint3Df p;
    in >> p.x >> p.y >> p.z;
    return p;
}

void write(CArchive& out, const InstanceView& v)
{
    out << v.frame << v.time << v.box.x << v.box.y << v.box.width << v.box.height << v.area
        << v.truncated << v.score << v.probability;
    write(out, v.camera);
    write(out, v.target);
}

InstanceView readView(CArchive& in)
{
    InstanceView v;
    in >> v.frame >> v.time >> v.box.x >> v.box.y >> v.box.width >> v.box.height >> v.area;
    v.truncated = readTruth(in);
    in >> v.score >> v.probability;
    v.camera = readPoint(in);
    v.target = readPoint(in);
    if (!v.isPossible()) throw std::runtime_error("corrupt map: a view with impossible numbers");
    return v;
}

void write(CArchive& out, const InstanceEvent& e)
{
    out << static_cast<uint8_t>(e.kind) << e.frame << e.instance << e.other;
}

InstanceEvent readEvent(CArchive& in)
{
    InstanceEvent e;
    const auto kind = in.ReadAs<uint8_t>();
    if (kind > static_cast<uint8_t>(InstanceEvent::Kind::divided))
        throw std::runtime_error("corrupt map: an event of no known kind");
    e.kind = static_cast<InstanceEvent::Kind>(kind);
    in >> e.frame >> e.instance >> e.other;
    return e;
}

void checkCategory(category_id_t category, const CategoryTable& categories)
{
    if (category >= categories.size())
        throw std::runtime_error("corrupt map: evidence for a category it lacks");
}

void write(CArchive& out, const CategoryEvidence& evidence)
{
    out << static_cast<uint32_t>(evidence.entries().size());
    for (const auto& e : evidence.entries()) out << e.category << e.beta;
}

CategoryEvidence readCategoryEvidence(CArchive& in, const CategoryTable& categories)
{
    CategoryEvidence evidence;
    for (auto n = in.ReadAs<uint32_t>(); n > 0; --n) {
        const auto category = in.ReadAs<category_id_t>();
        checkCategory(category, categories);
        evidence.add(category, readEvidence<double>(in));
    }
    return evidence;
}

void write(CArchive& out, const CategoryOpinions& o)
{
    write(out, o.sum());
    write(out, o.ofNoSide());
    out << static_cast<uint32_t>(o.bySide().size());
    for (const auto& s : o.bySide()) {
        out << s.side << s.opinions;
        write(out, s.sum);
    }
}

/** \param version of the map: before the fourth, opinions had no side */
CategoryOpinions readOpinions(CArchive& in, const CategoryTable& categories, uint8_t version)
{
    CategoryEvidence sum = readCategoryEvidence(in, categories);
    CategoryEvidence ofNoSide = version < 4 ? sum : readCategoryEvidence(in, categories);
    std::vector<CategoryOpinions::OfSide> bySide;
    for (auto n = version < 4 ? 0 : in.ReadAs<uint32_t>(); n > 0; --n) {
        CategoryOpinions::OfSide& s = bySide.emplace_back();
        in >> s.side >> s.opinions;
        s.sum = readCategoryEvidence(in, categories);
    }
    try {
        return CategoryOpinions::restored(std::move(sum), std::move(ofNoSide), std::move(bySide));
    } catch (const std::invalid_argument& e) {
        throw std::runtime_error(std::string("corrupt map: ") + e.what());
    }
}

template <typename Items>
void writeAll(CArchive& out, const Items& items)
{
    out << static_cast<uint32_t>(items.size());
    for (const auto& item : items) write(out, item);
}
}  // namespace

void write(CArchive& out, const Decision& d)
{
    out << d.category << d.evidence << d.source << d.model << d.answer << d.time << d.seconds
        << d.promptTokens << d.answerTokens << d.cost << d.questions;
}

Decision readDecision(CArchive& in, const CategoryTable& categories)
{
    Decision d;
    in >> d.category;
    if (d.category != UNKNOWN_CATEGORY_ID) checkCategory(d.category, categories);
    d.evidence = readEvidence<double>(in);
    d.source = readText(in);
    d.model = readText(in);
    d.answer = readText(in);
    in >> d.time >> d.seconds >> d.promptTokens >> d.answerTokens >> d.cost >> d.questions;
    return d;
}

void write(CArchive& out, const VoxelCoord& c)
{
    out << c.x << c.y << c.z;
}

VoxelCoord readBlockCoord(CArchive& in)
{
    VoxelCoord c;
    in >> c.x >> c.y >> c.z;
    if (!isInRange(c)) throw std::runtime_error("corrupt map: a block too far away");
    return c;
}

void write(CArchive& out, const Instance& i)
{
    out << i.id << i.observations << i.firstFrame << i.lastFrame << i.tracks;
    write(out, i.categories);
    writeAll(out, i.blocks);
    out << static_cast<uint32_t>(i.views.byCategory().size());
    for (const auto& [category, views] : i.views.byCategory()) {
        out << category;
        writeAll(out, views);
    }
    writeAll(out, i.history);
    writeAll(out, i.decisions);
}

Instance readInstance(CArchive& in, const CategoryTable& categories, uint32_t viewsKept,
                      uint8_t version)
{
    Instance i;
    in >> i.id >> i.observations >> i.firstFrame >> i.lastFrame >> i.tracks;
    i.categories = readOpinions(in, categories, version);
    for (auto n = in.ReadAs<uint32_t>(); n > 0; --n) i.blocks.insert(readBlockCoord(in));
    for (auto n = in.ReadAs<uint32_t>(); n > 0; --n) {
        const auto category = in.ReadAs<category_id_t>();
        checkCategory(category, categories);
        for (auto views = in.ReadAs<uint32_t>(); views > 0; --views)
            i.views.add(category, readView(in), viewsKept);
    }
    for (auto n = in.ReadAs<uint32_t>(); n > 0; --n) i.history.push_back(readEvent(in));
    for (auto n = in.ReadAs<uint32_t>(); n > 0; --n)
        i.decisions.push_back(readDecision(in, categories));
    return i;
}
}  // namespace voxeland
