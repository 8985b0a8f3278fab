// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tether {

/// Where a watched number is doubtful, and where it ends the run; 0 switches either off.
struct Limit {
  double warn = 0, stop = 0;
};

/// What a run that goes wrong is known by, as the deck's group $limits describes it; without a deck all are off.
struct Limits {
  Limit quality;      ///< least volume of an element over that at the start: below
  Limit volume;       ///< a body's volume over that at the start, or the other way round: below
  Limit energy_step;  ///< rise of the energy that nothing booked explains, from one look to the next, over the largest
                      ///< energy before or exchanged meanwhile: above
  Limit energy_growth;  ///< the same since the start: warns above a part of the largest energy exchanged, stops above a
                        ///< multiple of the energy at the start, or of what was booked or fell since
  Limit splitting;      ///< size of the mismatch of the power across the interface: above
  Limit cfl;            ///< cells that the fluid in a box crosses in a step: above
};

}  // namespace tether
