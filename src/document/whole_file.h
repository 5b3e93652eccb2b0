// Files that are whole or absent: written under a temporary name in the target's folder, then
// renamed.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace antumbra {

// Calls `write` with the temporary name (same ending as the target's), then renames. A symbolic
// link is followed: its target is replaced, not the link. Throws InputError that opens with `where`
// if the target exists and is no regular file (a folder, a device) or the rename fails; on any
// exception the temporary file is removed.
void writeWholeFile(const std::filesystem::path& target, const std::string& where,
                    const std::function<void(const std::filesystem::path& temporary)>& write);

// What writeWholeFile would fail by, before long work: throws InputError that opens with `where`
// unless the target's folder exists and may be written to, and the target is absent or a regular
// file.
void requireWritable(const std::filesystem::path& target, const std::string& where);

}  // namespace antumbra
