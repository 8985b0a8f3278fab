# SPDX-License-Identifier: GPL-3.0-or-later
"""Every deck of tests/bad_decks is refused with the message it names, at the right place, and nothing is written.

A deck's first line says what is wrong, its second what the message must hold (`expect: ` where the deck cannot be read,
`expect-scene: ` where what it asks for cannot be built). A comment `! <- here` marks the line that must be blamed.
"""
import pathlib
import resource
import unittest

from full_length import FULL
from program import ROOT, ProgramTest, diagnostics, run

FOLDER = pathlib.Path("tests/bad_decks")  # relative, as a user would type it
MARK = "! <- here"
AT_ONCE = 1 if FULL else 100  # decks in a call: most of what one takes is the start of the program

# Mistakes that no line can be blamed for.
PLACELESS = {"no_in", "particles_cut_off", "particles_short", "particles_single_point", "particles_two_sequences",
             "steps_lost"}

# Kinds of mistake that must be covered.
REQUIRED = {
    "unknown_group", "unknown_variable", "wrong_type", "integer_overflow", "real_overflow", "subscript_out_of_range",
    "past_array_end", "unclosed_group", "negative_density", "too_few_nodes", "negative_tmax",
    "particles_missing", "particles_not_named", "particles_short", "particles_ambiguous", "particles_absolute_path",
    "particles_climbing_path", "particles_outside", "particles_gas", "particles_single_point", "heavy_beyond_rows",
    "region_outside", "region_without_points", "region_of_two_vertices", "region_without_density", "vertex_not_given",
    "no_square", "huge_grid", "huge_region", "edges_reversed", "unknown_law", "no_stiffness",
    "incompressible", "output_without_interval", "reference_of_one_gas", "reference_without_string",
    "membrane_without_thickness", "membrane_without_count", "membrane_count_and_spacing", "membrane_of_one_point",
    "huge_membrane", "membrane_outside", "membrane_with_a_gap", "membrane_closed_and_pinned", "membrane_without_curve",
    "membrane_apart",
    "curve_without_kind", "curve_without_radius", "curve_of_three_vertices", "curve_vertex_without_y",
    "curve_without_length", "curve_beyond_a_turn", "membrane_on_the_axis", "particles_on_the_axis",
    "grid_beyond_the_axis", "wall_on_the_axis", "plane_stress_about_an_axis", "pin_of_a_solid",
    "region_bow_tie", "particles_in_one_place", "decimal_comma", "c_comment", "slashes_comment", "name_of_another_code",
    "particles_plane_stress_ratio", "rigid_on_a_plane_mesh", "rigid_without_a_mesh", "rigid_directors_in_a_plane",
    "rigid_director_without_length", "rigid_without_density", "rigid_pinned_and_moving", "rigid_regions_that_part",
    "rigid_region_that_spins", "rigid_force_without_place", "rigid_table_without_torque", "rigid_at_a_wall",
    "rigid_with_supports", "rigid_point_far_away", "rigid_without_time", "rigid_with_damping", "rigid_by_central_differences",
    "mesh_about_an_axis", "mesh_supports_at_odds", "mesh_edge_through_the_body", "mesh_load_without_size", "mesh_hinged",
    "mesh_edge_off_its_curve", "mesh_file_absolute", "mesh_file_changed", "mesh_file_climbing",
    "mesh_file_cut_off", "mesh_file_missing", "mesh_file_unknown_group",
    "mesh_hanging_nodes", "mesh_incompressible", "mesh_inverted_element", "mesh_load_expression", "mesh_load_in_z",
    "mesh_load_table_descending", "mesh_load_table_unequal", "mesh_load_without_side", "mesh_partly_constrained",
    "mesh_plane_stress_in_space", "mesh_region_of_three_vertices", "mesh_support_in_z", "mesh_support_of_nothing",
    "mesh_table_and_expression", "mesh_unconstrained", "mesh_unknown_element", "mesh_unknown_law",
    "mesh_unknown_side", "mesh_without_density", "mesh_z_of_one_region",
    "coupled_about_an_axis", "coupled_all_obstacle", "coupled_all_void", "coupled_body_in_an_obstacle",
    "coupled_body_in_space", "coupled_body_outside", "coupled_cavities_without_bodies", "coupled_depth_inverted",
    "coupled_fluid_region", "coupled_friction_without_contact",
    "coupled_hinge_that_moves", "coupled_hinge_without_body", "coupled_hinge_without_y", "coupled_huge",
    "coupled_inverted_element", "coupled_jet_expression", "coupled_jet_half_given", "coupled_jet_in_a_body",
    "coupled_jet_in_an_obstacle", "coupled_jet_in_depth", "coupled_jet_inverted", "coupled_opening_beyond",
    "coupled_jet_on_the_back", "coupled_jet_outside", "coupled_jet_without_side", "coupled_jet_without_speed",
    "coupled_no_cavity", "coupled_nz_without_ends", "coupled_obstacle_inverted", "coupled_obstacle_outside",
    "coupled_one_cell", "coupled_open_front", "coupled_plane_body_in_space",
    "coupled_spring_along_z", "coupled_spring_on_no_region", "coupled_spring_on_nothing",
    "coupled_spring_without_stiffness", "coupled_start_along_z", "coupled_static", "coupled_unbalanced",
    "coupled_unbalanced_behind_an_obstacle", "coupled_unbalanced_later", "coupled_thin_obstacle",
    "coupled_liquid_in_a_body", "coupled_liquid_nowhere", "coupled_liquid_without_a_surface",
    "coupled_liquid_given_twice", "coupled_liquid_bow_tie", "coupled_liquid_polygon_cut_off", "coupled_liquid_outside",
    "coupled_liquid_and_open_side", "coupled_liquid_and_void", "coupled_liquid_by_splitting", "coupled_liquid_and_smoke",
    "coupled_sealed_without_air", "coupled_jet_in_a_slope", "coupled_plane_without_direction",
    "coupled_plane_half_given", "coupled_body_in_a_slope",
    "coupled_liquid_without_a_height",
    "coupled_unbalanced_by_the_later_jet", "coupled_void_without_end",
    "coupled_with_a_flow", "coupled_with_a_rigid_body", "coupled_without_density", "coupled_zback_without_nz",
    "flow_about_an_axis", "flow_body_in_a_hole", "flow_body_on_an_inflow", "flow_body_outside",
    "flow_difference_of_nothing", "flow_expression", "flow_expression_not_finite", "flow_force_between_blocks",
    "flow_force_not_finite", "flow_in_space", "flow_in_two_parts", "flow_inflow_without_velocity", "flow_kind_without_side",
    "flow_load_on_the_fluid", "flow_load_without_body", "flow_moving_through_itself", "flow_moving_without_velocity",
    "flow_of_a_mesh_file", "flow_of_two_densities", "flow_partner_of_an_open_side", "flow_periodic_not_parallel",
    "flow_periodic_of_other_nodes", "flow_periodic_without_partner", "flow_probe_outside", "flow_probe_without_y",
    "flow_side_between_blocks", "flow_side_named_twice", "flow_side_without_kind", "flow_slip_on_a_slope",
    "flow_solids_by_trapezoid", "flow_speed_without_length", "flow_static", "flow_steady_moves",
    "flow_tracers_outside", "flow_tracked_without_body", "flow_unbalanced", "flow_unbalanced_later",
    "flow_unknown_kind", "flow_unknown_side", "flow_velocity_on_a_periodic_side", "flow_velocity_on_a_slip_wall",
    "flow_velocity_on_a_wall", "flow_velocity_on_an_open_side", "flow_with_a_rigid_body", "flow_without_a_fluid",
    "flow_without_a_mesh", "flow_without_density", "flow_without_viscosity", "flow_of_triangles", "flow_of_four_nodes",
    "flow_of_both", "flow_of_a_file_in_two_parts", "flow_file_without_the_group", "flow_file_without_the_side",
    "flow_body_without_fluid", "flow_of_curved_triangles", "flow_body_across_a_hole", "flow_body_around_a_hole",
    "mesh_two_gradings",
    "contact_at_a_wall_twice", "contact_at_the_back", "contact_beyond_a_plane", "contact_beyond_a_wall",
    "contact_by_central_differences", "contact_by_the_midpoint_rule", "contact_by_the_trapezoidal_rule",
    "contact_friction_twice", "contact_in_a_steady_flow", "contact_in_an_obstacle", "contact_in_linear_steps",
    "contact_in_splitting", "contact_obstacle_half_given", "coupled_energy_by_splitting",
    "contact_obstacle_in_depth", "contact_obstacle_inverted", "contact_of_bodies_that_cross",
    "contact_of_bodies_that_overlap", "contact_of_nothing", "contact_on_an_inner_region", "contact_on_no_region",
    "contact_obstacle_through", "contact_obstacle_within", "contact_in_a_box_overlap",
    "contact_on_no_side", "contact_plane_half_given", "contact_plane_in_space", "contact_plane_without_normal",
    "contact_pushed_by_friction", "contact_stick_backwards", "contact_unknown_step", "contact_unknown_wall",
    "contact_with_a_rigid_body", "contact_without_a_mesh", "contact_without_gap",
    "contact_without_stiffness", "contact_touching",
    "coupled_mesh_and_liquid", "coupled_mesh_and_void",
    "coupled_mesh_and_mode", "coupled_mesh_near_above_size", "coupled_mesh_obstacles_touch",
    "coupled_mesh_size_on_a_grid",
}


def lines_of(path):
    return (ROOT / path).read_bytes().decode("utf-8", "surrogateescape").splitlines()


def expected_fragment(deck):
    for prefix in ("expect: ", "expect-scene: "):
        if lines_of(deck)[1].startswith(prefix):
            return lines_of(deck)[1].removeprefix(prefix)
    raise AssertionError(f"{deck}: its second line names no message")


def marked_line(deck):
    """file:line that the deck or its particle file marks, or None."""
    for path in (deck, deck.with_suffix(".par")):
        if (ROOT / path).exists():
            for number, line in enumerate(lines_of(path), 1):
                if line.endswith(MARK):
                    return f"{path}:{number}"
    return None


class BadDecks(ProgramTest):
    def refuse(self, *decks):
        """Runs the decks in one call, which writes nothing; what it says."""
        out = self.folder / "out"
        result = run(*decks, "--out", out)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stdout, "")
        self.assertFalse(out.exists())
        return diagnostics(result.stderr)

    def the_error(self, deck, found):
        """The one error of this deck, its particles or its mesh that holds the deck's fragment, with the lines below
        its head."""
        fragment = expected_fragment(deck)
        of_deck = [(head, below) for head, below in found if pathlib.Path(head["file"]).stem == deck.stem]
        told = [(head, below) for head, below in of_deck
                if head["severity"] == "error" and fragment in "\n".join([head["text"], *below])]
        self.assertEqual(len(told), 1, [head.group(0) for head, _ in of_deck])
        return told[0]

    def check_place(self, deck, head, below):
        """The error stands at file:line:column, shows that line, and its caret stands under that column."""
        self.assertTrue(head["column"], head.group(0))
        line, column = int(head["line"]), int(head["column"])
        text = lines_of(head["file"])[line - 1]
        self.assertEqual(below[0], "  " + text)
        self.assertEqual(below[1].index("^"), 2 + column - 1)
        mark = marked_line(deck)
        if mark:
            self.assertEqual(f"{head['file']}:{line}", mark)

    def test_each_is_refused_at_its_place(self):
        decks = sorted(path.relative_to(ROOT) for path in (ROOT / FOLDER).glob("*.in"))
        for first in range(0, len(decks), AT_ONCE):
            found = self.refuse(*decks[first:first + AT_ONCE])
            for deck in decks[first:first + AT_ONCE]:
                with self.subTest(deck=deck.name):
                    self.check(deck, *self.the_error(deck, found))

    def check(self, deck, head, below):
        self.assertTrue(lines_of(deck)[0])
        if deck.stem in PLACELESS:
            self.assertIsNone(head["line"])
            self.assertIn(head["file"], (str(deck), str(deck.with_suffix(".par"))))
        else:
            self.check_place(deck, head, below)

    def test_every_kind_of_mistake_is_there(self):
        there = {path.stem for path in (ROOT / FOLDER).glob("*.in")}
        self.assertEqual(REQUIRED - there, set())

    def test_what_needs_no_grid_is_told_without_one(self):
        deck = self.write("half.in", "no grid and no clock\n$in\n igen=1, cyl=1., xleft=-1.\n$\n$reg nreg=1 $\n"
                          "$membrane curve(1)='line', x(1,1)=0.,1., y(1,1)=0.,0., density(1)=1. $\n"
                          "$mpm edge(1)='inflow' $\n$limits quality=.1,.5 $\n")
        result = run("check", deck)
        self.assertEqual(result.returncode, 2)
        for text in ("$in lacks nx, ny, xright, ybot, ytop, tmax, tstep", "xleft = -1 lies beyond the axis", "region 1",
                     "thickness(1)", "count(1)", "an inflow needs edge_density(1)", "quality: the run stops at 0.5"):
            self.assertIn(text, result.stderr)

    def test_a_huge_grid_is_refused_before_memory_is_taken(self):
        decks = [FOLDER / f"{name}.in" for name in ("huge_grid", "huge_region", "huge_membrane", "coupled_huge")]
        found = self.refuse(*decks)
        for deck in decks:
            self.the_error(deck, found)
        kilobytes = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss  # the largest of all runs up to here
        self.assertLess(kilobytes, 500_000)


if __name__ == "__main__":
    unittest.main()
