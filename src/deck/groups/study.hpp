// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "deck/variable.hpp"

namespace tether::study_table {

using bounds::above_zero;
using bounds::none;
using enum ValueType;

inline constexpr int most_decks = 20, most_axes = 20, most_sets = 50, most_quantities = 30;

// group, name, type, rank, n1, n2, unit, low, high, choices, default, meaning
inline constexpr std::array study_rows{
    Variable{study_group, "mode", text, 0, 1, 1, "", -none, none, "grid|ensemble|bisect|chart|map", "'grid'",
             "All combinations of the axes; or several runs of each with a value varied about its own; or the largest "
             "value of each for which a criterion holds; or error against cost of families of runs; or where over one "
             "or two axes a criterion "
             "holds."},
    Variable{study_group, "decks", text, 1, most_decks, 1, "", -none, none, "", "",
             "Base decks, each a path from the study deck's folder, at most one folder up."},
    Variable{study_group, "axis", text, 1, most_axes, 1, "", -none, none, "", "",
             "A deck value and the values it takes: 'group.name=v1,v2,...'; axis 1 changes fastest, decks slowest."},
    Variable{study_group, "linked", integer, 1, most_axes, 1, "", 0, most_axes, "", "0",
             "Axis that this axis moves along with, value by value; 0 for none."},
    Variable{study_group, "set", text, 1, most_sets, 1, "", -none, none, "", "",
             "A value that all runs share: 'group.name=value', as with --set."},
    Variable{study_group, "quantities", text, 1, most_quantities, 1, "", -none, none, "", "",
             "Columns of the table: keys of summary.txt, or first, last, max, min, time_of_max or time_of_min of a "
             "column of "
             "history.txt, 'last(body_vx_1)'."},
    Variable{study_group, "order", text, 0, 1, 1, "", -none, none, "", "''",
             "Column against which the observed order of each error_ quantity is reported, along axis 1 (grid)."},
    Variable{study_group, "vary", text, 0, 1, 1, "", -none, none, "", "''",
             "Real deck value, 'group.name', that an ensemble or a bisection varies; in a map it is bisected for each "
             "combination of the axes."},
    Variable{study_group, "fraction", real, 0, 1, 1, "", above_zero, none, "", "",
             "Ensemble: the value is varied evenly from 1 - fraction to 1 + fraction times its own."},
    Variable{study_group, "runs", integer, 0, 1, 1, "", 2, 100000, "", "", "Ensemble: number of runs."},
    Variable{study_group, "low", real, 0, 1, 1, "", -none, none, "", "",
             "Bisection: a value at which the criterion holds."},
    Variable{study_group, "high", real, 0, 1, 1, "", -none, none, "", "",
             "Bisection: a larger value, at which it does not hold."},
    Variable{study_group, "tolerance", real, 0, 1, 1, "", 1e-12, 1, "", "1e-3",
             "Bisection: length of the last interval over the larger of low and high in size."},
    Variable{
        study_group, "criterion", text, 0, 1, 1, "", -none, none, "", "''",
        "Bisection: exit_code (0 holds, without a bound), or what quantities can be (a run that fails then does not "
        "hold)."},
    Variable{study_group, "at_least", real, 0, 1, 1, "", -none, none, "", "",
             "Bisection: the criterion holds from this value on."},
    Variable{study_group, "at_most", real, 0, 1, 1, "", -none, none, "", "",
             "Bisection: the criterion holds up to this value."},
    Variable{study_group, "coarse", integer, 0, 1, 1, "", 1, 1000, "", "5",
             "Map without vary: every how-manieth value of an axis is run in any case; between them runs follow the "
             "border."},
    Variable{study_group, "theory", text, 0, 1, 1, "", -none, none, "", "''",
             "Map: where theory has the border, in values of vary, else of the last axis of numbers; an expression as "
             "those of $published, read off a run that holds."},
};

inline constexpr int most_families = 40, most_together = 10;

// group, name, type, rank, n1, n2, unit, low, high, choices, default, meaning
inline constexpr std::array chart_rows{
    Variable{study_group, "is", text, 0, 1, 1, "", -none, none, "", "''",
             "Chart: what is read off each run, an expression as those of $published, "
             "'first(body_y_1) - min(body_y_1)'."},
    Variable{
        study_group, "exact", text, 0, 1, 1, "", -none, none, "", "''",
        "Chart: the answer, an expression likewise, or 'converged': what the finest runs of the families lead to."},
    Variable{study_group, "family", text, 1, most_families, 1, "", -none, none, "", "",
             "Chart: name of family k of runs, those by one path or method from coarse to fine."},
    Variable{study_group, "family_deck", integer, 1, most_families, 1, "", 1, most_decks, "", "1",
             "Deck that family k runs: decks(family_deck(k))."},
    Variable{study_group, "family_set", text, 2, most_together, most_families, "", -none, none, "", "",
             "Value j that all runs of family k share, 'group.name=value'."},
    Variable{study_group, "cells", text, 2, most_together, most_families, "", -none, none, "", "",
             "What makes family k's runs finer in space, one after the other: 'in.ny=25,49,97'; several values move "
             "together. The first one counts cells, or nodes where it is nx, ny or nz."},
    Variable{study_group, "steps", text, 2, most_together, most_families, "", -none, none, "", "",
             "The same in time, of runs on the middle one of the meshes: 'in.tstep=.02,.01,.005'."},
    Variable{study_group, "space_order", real, 1, most_families, 1, "", above_zero, none, "", "",
             "Order of family k in space by its theory, shown next to what is found."},
    Variable{study_group, "step_order", real, 1, most_families, 1, "", above_zero, none, "", "", "The same in time."},
    Variable{study_group, "answer_by", integer, 0, 1, 1, "", 1, most_families, "", "",
             "Chart of a converged answer: the family whose cells lead to it; without it the best bounded one."},
    Variable{study_group, "setting", integer, 1, 2, 1, "", 1, 1000, "", "",
             "Chart: family and number of the run that was published; cheaper ones that are as accurate are named."},
};

inline constexpr int most_rows = 40, most_overrides = 20;

constexpr Variable text_of_problem(std::string_view name, std::string_view fallback, std::string_view meaning,
                                   std::string_view choices = "") {
  return {published_group, name, text, 0, 1, 1, "", -none, none, choices, fallback, meaning};
}
constexpr Variable overrides(std::string_view name, std::string_view meaning) {
  return {published_group, name, text, 1, most_overrides, 1, "", -none, none, "", "", meaning};
}
constexpr Variable text_of_row(std::string_view name, std::string_view fallback, std::string_view meaning,
                               std::string_view choices = "") {
  return {published_group, name, text, 1, most_rows, 1, "", -none, none, choices, fallback, meaning};
}

inline constexpr std::array published_rows{
    text_of_problem("name", "''", "Name of the problem for 'tether reproduce'; without it the deck's file name."),
    text_of_problem("source", "''", "What published the numbers: 'thesis'."),
    text_of_problem("place", "''", "Where that has them: '4.1, Figs 13, 14'."),
    text_of_problem("deck", "''",
                    "Deck to run, a path from this deck's folder, at most one folder up; without it this deck."),
    text_of_problem("like", "''", "Another deck whose $published gives what this one leaves out."),
    text_of_problem("compared_with", "''",
                    "A deck that is run as well, for readings that compare two runs: reference(f)."),
    text_of_problem("study", "''", "A bisection that is run on the deck in place of a single run."),
    text_of_problem("methods", "'both'", "By which methods material points are run: the thesis's, and the robust one.",
                    "thesis|both"),
    text_of_problem("varied", "'none'",
                    "Chaotic by these methods: ten runs whose steps differ by up to half a per cent.",
                    "none|thesis|robust|both"),
    overrides("thesis_set",
              "A value for the runs by the thesis's method, and of decks without points: "
              "'group.name=value'."),
    overrides("robust_set", "A value for the runs by the robust method."),
    text_of_row("quantity", "", "A row of the table: its name, with the unit where it has one."),
    text_of_row("is", "",
                "What the row reads off a finished run: an expression of keys of summary.txt and of functions of the "
                "run, 'max(body_y_3)'; row(1) stands for what an earlier row reads."),
    text_of_row("printed", "''",
                "What is printed, and where: '0.0071 (Table 3)' within half a unit of the last digit, '6 +- 3 % (Box "
                "10)', '= 0.05 (Box 2)' exactly, '< 1 (6.2)'; ' or ' between what contradicts itself."),
    text_of_row("judged", "'none'", "Whose values are judged by what is printed; the others' are reported.",
                "none|thesis|robust|both"),
    text_of_row("theory", "''", "What the source quotes of its theory, written as `printed`."),
    text_of_row("theory_for", "'exact'",
                "What theory is compared with: the exact value of the deck that ran, the runs, or nothing.",
                "exact|runs|nothing"),
    text_of_row("exact", "''", "The exact value of the deck that ran, written as `is`."),
    text_of_row("thesis_within", "''",
                "How near the thesis's method, or a deck without points, must come to the exact value: '2 %', or a "
                "size; without it the distance is reported."),
    text_of_row("robust_within", "''", "The same for the robust method."),
    text_of_row("thesis_to_theory", "''", "How near it must come to the theory, where that is for runs."),
    text_of_row("robust_to_theory", "''", "The same for the robust method."),
};

}  // namespace tether::study_table
