// SPDX-License-Identifier: BSD-3-Clause
/** What a server sends, and what a model says in it. */
#include "ChatProtocol.h"
#include "Reading.h"
#include "voxeland/disambiguation/AnswerParser.h"

using namespace voxeland;

namespace
{
std::vector<RankedCategory> candidates()
{
    std::vector<RankedCategory> ranked;
    for (const char* name : {"chair", "dining table", "tv"}) {
        RankedCategory category;
        category.category = static_cast<category_id_t>(ranked.size());
        category.name = name;
        ranked.push_back(category);
    }
    return ranked;
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    static const auto ranked = candidates();
    const std::string text(reinterpret_cast<const char*>(data), size);
    categoryNamedBy(text, ranked);
    serverMessage(text);
    remedyFor(text);
    try {
        categoryNamedBy(chatAnswer(text).text, ranked);
    } catch (const std::runtime_error&) {
        // What is wrong with the reply, as chatAnswer() says.
    }
    return 0;
}
