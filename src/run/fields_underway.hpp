// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

#include "fields/fields_in_turn.hpp"
#include "loops/channel.hpp"

// The fields of a snapshot on their way from the thread that makes them to the one that writes them.

namespace tether {

/// Makes the channel for the fields of this snapshot, of which no more than `most_waiting` bytes wait in it, or one
/// field.
std::shared_ptr<Channel> channel_for(const FieldsInTurn& snapshot, std::size_t most_waiting);

/// The snapshot with the fields that come through the channel, which closes when the last copy is gone: who puts any
/// into it then need not wait for somebody to take them.
FieldsInTurn fields_from(const std::shared_ptr<Channel>& channel, const FieldsInTurn& snapshot);

/// Makes all fields, as many at a time as the snapshot's team has threads, and puts them into the channel in turn.
void put_fields(const FieldsInTurn& snapshot, Channel& channel);

}  // namespace tether
