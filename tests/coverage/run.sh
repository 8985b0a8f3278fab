#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# tests/coverage/run.sh: which lines and branches of the deck reader its unit tests run; fails below the limits here.
set -euo pipefail
cd "$(dirname "$0")/../.."

cmake --preset coverage
cmake --build --preset coverage
find build/coverage -name '*.gcda' -delete
build/coverage/tests/test_deck --gtest_brief=1
gcovr --root . --filter src/deck/ --exclude-throw-branches --exclude-unreachable-branches --print-summary \
  --fail-under-line 95 --fail-under-branch 90 build/coverage
