// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/columns.hpp"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

namespace tether {
namespace {

using Names = std::vector<std::string>;
using D = Dimension;

/// A made-up physics: its setting, what a record of it is made from, and what it shares with others.
struct Setting : ColumnSetting {
  bool heated = false;
  std::size_t probes = 0;
};
struct Shared {
  double time = 0;
  std::vector<std::array<double, 3>> places;
};
struct Source : Shared {
  double heat = 0;
  std::vector<double> probed;
};

ColumnGroup<ColumnSetting, Shared> shared() {
  using Row = Column<ColumnSetting, Shared>;
  return {{{"time", D::time, "time", &Shared::time},
           Row("body_", D::length, "centre",
               [](const Shared& s, std::size_t axis, std::size_t b) { return s.places[b][axis]; })
               .vector()
               .each(Per::body)}};
}

using Row = Column<Setting, Source>;

ColumnGroup<Setting, Source> heat() {
  return {{"where it is heated", [](const Setting& s) { return s.heated; }},
          {Row("energy_heat", D::energy, "heat", &Source::heat).booked(Book::gained),
           Row("turned", D::number, "twice the heat", [](const Source& s) {
             return 2 * s.heat;
           }).when("in space", [](const Setting& s) { return s.dim == 3; })}};
}

ColumnGroup<Setting, Source> probes() {
  const auto value = [](const Source& s, std::size_t k) { return s.probed[k]; };
  return numbered<Setting, Source>(
      {{"at probes", [](const Setting& s) { return s.probes; }},
       {Row("probe", D::stress, "what is probed", value).meaning_of([](const Setting&, std::size_t k) {
          return "at " + std::to_string(k + 1);
        }),
        {"minus", D::stress, "less that", [](const Source& s, std::size_t k) { return -s.probed[k]; }}}});
}

const ColumnTable<Setting, Source>& table() {
  static const ColumnTable<Setting, Source> all({shared(), heat(), probes()});
  return all;
}

Source source() { return {{5, {{1, 2, 3}, {4, 5, 6}}}, 7, {8, 9}}; }

TEST(Columns, HaveLayoutAndRecordFromTheSameRows) {
  const Columns<Source> columns(table(), Setting{{2, {"a", "b"}, {}}, true, 2});
  EXPECT_EQ(columns.layout().column_names(), (Names{"time", "body_x_1", "body_x_2", "body_y_1", "body_y_2",
                                                    "energy_heat", "probe_1", "minus_1", "probe_2", "minus_2"}));
  EXPECT_EQ(columns.record(source()), (Record{5, 1, 4, 2, 5, 7, 8, -8, 9, -9}));
}

TEST(Columns, CarryWhatTheRowSays) {
  const Columns<Source> columns(table(), Setting{{2, {"a", "b"}, {"p"}}, true, 2});
  const auto& quantities = columns.layout().quantities;
  EXPECT_EQ(quantities[1].meaning, "centre, x");
  EXPECT_EQ(quantities[1].per, Per::body);
  EXPECT_EQ(quantities[3].dimension, D::energy);
  EXPECT_EQ(quantities[3].book, Book::gained);
  EXPECT_EQ(quantities[6].meaning, "at 2");
  EXPECT_EQ(quantities[7].meaning, "less that");
  EXPECT_EQ(columns.layout().body_names, (Names{"a", "b"}));
  EXPECT_EQ(columns.layout().point_names, (Names{"p"}));
}

TEST(Columns, LeaveOutTheRowsAndGroupsWhoseConditionFails) {
  const Columns<Source> none(table(), Setting{{3, {"a"}, {}}, false, 0});
  EXPECT_EQ(none.layout().column_names(), (Names{"time", "body_x_1", "body_y_1", "body_z_1"}));
  EXPECT_EQ(none.record(source()), (Record{5, 1, 2, 3}));
  const Columns<Source> space(table(), Setting{{3, {}, {}}, true, 0});
  EXPECT_EQ(space.layout().column_names(), (Names{"time", "energy_heat", "turned"}));
  EXPECT_EQ(space.record(source()), (Record{5, 7, 14}));
}

TEST(ColumnGroup, TakesOneCondition) {
  const When<Setting> heated("where it is heated", [](const Setting& s) { return s.heated; });
  const ColumnGroup<Setting, Source> group = given<Setting, Source>(heated, shared());
  EXPECT_EQ(group.when.times(Setting{{}, true, 0}), 1u);
  EXPECT_EQ(group.when.times(Setting{{}, false, 0}), 0u);
  EXPECT_THROW((given<Setting, Source>(heated, group)), std::logic_error);
}

TEST(Columns, RefuseTwoRowsOfOneName) {
  const ColumnTable<Setting, Source> twice({heat(), heat()});
  EXPECT_NO_THROW(Columns<Source>(twice, Setting{}));
  EXPECT_THROW(Columns<Source>(twice, Setting{{}, true, 0}), std::logic_error);
}

TEST(Columns, MakeASnapshotOfAsManyNumbersAsAreAskedFor) {
  const auto value = [](const Source& s, std::size_t k) { return s.probed[k]; };
  const ColumnTable<Setting, Source> fields({{{Row("probed", D::stress, "what is probed", value)}}});
  const Snapshot snapshot = Columns<Source>(fields, Setting{}).snapshot(3, 2, source());
  EXPECT_EQ(snapshot.time, 3);
  ASSERT_EQ(snapshot.fields.size(), 1u);
  EXPECT_EQ(snapshot.fields[0].quantity.name, "probed");
  EXPECT_EQ(snapshot.fields[0].values, (std::vector<double>{8, 9}));
}

TEST(ColumnTable, DescribesAllItsRowsWhateverTheSetting) {
  const auto texts = table().described();
  ASSERT_EQ(texts.size(), 6u);
  EXPECT_EQ(texts[1].name, "body_x_1, y, z");
  EXPECT_EQ(texts[1].when, "");
  EXPECT_EQ(texts[3].name, "turned");
  EXPECT_EQ(texts[3].when, "where it is heated, in space");
  EXPECT_EQ(texts[4].name, "probe_1");
}

TEST(ColumnsListing, HasALineForEachColumnOfEachPhysics) {
  EXPECT_EQ(
      columns_listing({{"points", {{"heat", D::energy, "heat", "if hot"}}}, {"bars", {{"t", D::time, "time", ""}}}}),
      "points\n  heat                         energy            heat (if hot)\n"
      "bars\n  t                            time              time\n");
}

TEST(ColumnsMarkdown, JoinsRowsOfOneMeaning) {
  const ColumnText time{"time", D::time, "time", ""}, heat{"heat", D::energy, "heat", "if hot"};
  ColumnText other = heat;
  other.meaning = "another heat";
  EXPECT_EQ(columns_markdown({{"points", {heat, time}}, {"bars", {time, other}}, {"flows", {time, heat}}}),
            "| column | dimension | of | meaning |\n|---|---|---|---|\n"
            "| heat | energy | points, flows: if hot | heat |\n"
            "| heat | energy | bars: if hot | another heat |\n"
            "| time | time | all | time |\n");
}

}  // namespace
}  // namespace tether
