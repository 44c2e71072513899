// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/base/nearestWord.h"

#include "voxeland/base/lowerCase.h"

#include <algorithm>
#include <numeric>

namespace voxeland
{
namespace
{
/** Number of single-character edits between two words (Levenshtein). */
size_t editDistance(const std::string& a, const std::string& b)
{
    std::vector<size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), size_t{0});
    for (size_t i = 1; i <= a.size(); ++i) {
        size_t diagonal = row[0];
        row[0] = i;
        for (size_t j = 1; j <= b.size(); ++j) {
            const size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
        }
    }
    return row.back();
}
}  // namespace

std::string nearestWord(const std::string& misspelt, const std::vector<std::string>& words)
{
    std::string nearest;
    size_t least = std::max<size_t>(2, misspelt.size() / 2) + 1;
    for (const auto& word : words) {
        const size_t distance = editDistance(lowerCase(misspelt), lowerCase(word));
        if (distance >= least) continue;
        least = distance;
        nearest = word;
    }
    return nearest;
}
}  // namespace voxeland
