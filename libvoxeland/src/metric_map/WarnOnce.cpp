// SPDX-License-Identifier: BSD-3-Clause
#include "WarnOnce.h"

#include "voxeland/base/printable.h"

#include <iostream>
#include <mutex>
#include <set>

namespace voxeland
{
void warnOnce(const std::string& sentence)
{
    constexpr size_t LONGEST = 600;
    static std::mutex mutex;
    static std::set<std::string> told;
    const std::lock_guard<std::mutex> lock(mutex);
    if (told.insert(sentence).second)
        std::cerr << printableSentence("voxeland map: warning: " + sentence, LONGEST) << "\n";
}
}  // namespace voxeland
