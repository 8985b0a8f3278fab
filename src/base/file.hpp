// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace tether {

/// The whole file as bytes. Throws FileError with the system's reason; nothing but a regular file is read, so that a
/// read comes to an end, whoever writes into a pipe or never does.
std::string read_file(const std::filesystem::path& path);

/// Throws the FileError of read_file() where the path leads to something else than a regular file.
void refuse_irregular_file(const std::filesystem::path& path);

/// Writes the whole text and checks every step, the close included. Throws FileError.
void write_file(const std::filesystem::path& path, std::string_view text);

/// Renames a finished file to `path`, in place of one that is there, so that not even a power cut leaves anything but
/// the old file or the whole new one: the disk has the file before the name, and the name before this returns. Throws
/// FileError.
void put_in_place(const std::filesystem::path& fresh, const std::filesystem::path& path);

/// Where a replaced file has got to when the call returns: to the system, which survives the program, or to the disk.
enum class Reach { system, disk };

/// Has `write` make a file under the temporary name that it is given, then puts that into the place of `path` in one
/// go: whoever reads sees the old file or the whole new one. Where something is thrown, the old one stays and no
/// temporary file. Throws FileError, and what `write` throws.
void replace_whole(const std::filesystem::path& path, Reach reach,
                   const std::function<void(const std::filesystem::path&)>& write);

}  // namespace tether
