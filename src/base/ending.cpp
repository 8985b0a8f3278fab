// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ending.hpp"

#include <fmt/format.h>

#include <new>
#include <system_error>

#include "base/diagnostics.hpp"
#include "base/errors.hpp"
#include "base/short_text.hpp"

namespace tether {

Ending end_of(const std::string& name, const std::function<void()>& work) {
  const auto told = [&name](const char* what) { return with_short_words(fmt::format("{}: error: {}\n", name, what)); };
  try {
    work();
    return {};
  } catch (const InputError& error) {
    const bool names_its_file = !error.diagnostics().front().place.file.empty();
    return {exit_input, (names_its_file ? "" : name + ": ") + error.what()};
  } catch (const std::bad_alloc&) {
    return {exit_input, told("it needs more memory than there is")};
  } catch (const RunError& error) {
    return {exit_run, told(error.what())};
  } catch (const FileError& error) {
    return {exit_file, told(error.what())};
  } catch (const std::system_error& error) {  // as of a terminal or a pipe that takes no more text
    return {exit_file, told(error.what())};
  } catch (const Interrupted& interrupted) {
    return {exit_signal + interrupted.signal(), fmt::format("{}: {}\n", name, interrupted.what())};
  }
}

}  // namespace tether
