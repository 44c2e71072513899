// SPDX-License-Identifier: BSD-3-Clause
#include "removeTree.h"

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

// opendir() takes memory, which a handler of signals must not: the kernel is asked itself.
namespace voxeland
{
namespace
{
/** An entry as getdents64() gives it; its name follows. */
struct Entry
{
    uint64_t inode;
    int64_t offset;
    uint16_t size;
    uint8_t type;
    char name[1];
};

bool isEntry(const char* name)
{
    return std::strcmp(name, ".") != 0 && std::strcmp(name, "..") != 0;
}

/** Removes what one reading of a folder shows. \return whether that was anything */
bool removeEntries(int folder)
{
    bool any = false;
    alignas(Entry) char entries[4096];
    lseek(folder, 0, SEEK_SET);
    for (;;) {
        const long bytes = syscall(SYS_getdents64, folder, entries, sizeof(entries));
        if (bytes <= 0) return any;
        for (long at = 0; at < bytes;) {
            const char* entry = entries + at;
            const char* name = entry + offsetof(Entry, name);
            uint16_t size = 0;
            std::memcpy(&size, entry + offsetof(Entry, size), sizeof(size));
            if (isEntry(name)) {
                removeTree(folder, name);
                any = any || faccessat(folder, name, F_OK, AT_SYMLINK_NOFOLLOW) != 0;
            }
            at += size;
        }
    }
}
}  // namespace

void removeTree(int parent, const char* name)
{
    if (unlinkat(parent, name, 0) == 0 || errno != EISDIR) return;
    const int folder = openat(parent, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (folder < 0) return;
    while (removeEntries(folder)) continue;  // a reading may pass over some where others vanish
    close(folder);
    unlinkat(parent, name, AT_REMOVEDIR);
}
}  // namespace voxeland
