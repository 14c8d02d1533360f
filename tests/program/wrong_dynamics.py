"""Wrong cases of explicit dynamics, one fault each."""

import json

from right_cases import CASE, DYNAMICS, Wrong, replaced


def wrong_dynamics():
    table = [  # path, value, in the message, whether the schema sees it
        ("analysis/plane", "stress", 'expected "strain"', True),
        ("analysis/time_step", 0, "> 0", True),
        ("analysis/time_step", -1e-3, "> 0", True),
        ("analysis/time_step", 1e300, "1e+30", True),
        ("analysis/time_step", "atuo", '"auto"', True),
        ("analysis/time_step", "NaN", '"auto"', True),
        ("analysis/safety", 0, "> 0", True),
        ("analysis/safety", 1.1, "1", True),
        ("analysis/end_time", 0, "> 0", True),
        ("analysis/end_time", -1, "> 0", True),
        ("analysis/end_time", "1", "a number", True),
        ("analysis/mass", "lumpd", 'nearest: "lumped"', True),
        ("analysis/mass", "partly-lumped", 'nearest: "partly_lumped"', True),
        ("analysis/transfer", 1.5, "1", True),
        ("analysis/transfer", -0.1, "0", True),
        ("analysis/transfer", "apic", '"pic"', True),
        ("analysis/damping", 1, "< 1", True),
        ("analysis/damping", -0.1, "≥ 0", True),
        ("analysis/leaving", "ignore", '"stop", "drop"', True),
        ("material/type", "linear_elastic", '"linear_large"', True),
        ("material/type", "neohookean", 'nearest: "neo_hookean"', True),
        ("material/density", 0, "> 0", True),
        ("boundaries/0/condition/method", "nitshe", 'nearest: "nitsche"', True),
        ("boundaries/0/condition/method", "nitsche", 'method "grid" alone', False),
        ("boundaries/1/condition/method", "implicit_boundary", 'method "grid" alone', False),
        ("boundaries/3/condition/method", "nitsche", 'method "grid" alone', False),
        ("boundaries/2/condition/value/1", "p*z", "character 3", False),
        ("gravity", [0], "list of 2", True),
        ("gravity/1", [0], "a number", True),
        ("initial_velocity", 1, "list of 2", True),
        ("initial_velocity/0", "p*z", "character 3", False),
        ("exact/type", "self_weight_colum", 'nearest: "self_weight_column"', True),
        ("exact/height", 0, "> 0", True),
        ("history", 10, "an object", True),
        ("history/every", 0, "from 1", True),
        ("history/every", 1.5, "whole number", True),
        ("diagnostics/error_estimate", "yes", "true or false", True),
        ("output/every", 0, "from 1", True),
    ]
    for path, value, words, structural in table:
        yield Wrong(f"dynamics: {path} = {value!r}", replaced(path, value, DYNAMICS), "/" + path,
                    ["formula" if words == "character 3" else "", words], structural)

    listed = {"points": [[0.25, 0.25], [0.75, 0.25]], "volumes": [0.25, 0.25]}
    fixed_step = {**DYNAMICS["analysis"], "time_step": 1e-3}
    without_safety = {key: value for key, value in fixed_step.items() if key != "safety"}
    without_gravity = {key: value for key, value in DYNAMICS.items() if key != "gravity"}
    unbounded = {key: value for key, value in DYNAMICS.items() if key != "boundaries"}
    base = DYNAMICS["boundaries"][0]
    for name, case, pointer, words, structural in [
            ("a safety factor beside a time step", {**DYNAMICS, "analysis": fixed_step}, "/analysis/safety",
             ["found a safety factor", '"auto"'], False),
            ("a time step above the critical one",
             {**DYNAMICS, "analysis": {**without_safety, "time_step": 0.05}}, "/analysis/time_step",
             ["found 0.05 s", "expected at most ", "critical step", "partly_lumped", '"auto"'], False),
            ("a huge time step", {**DYNAMICS, "analysis": {**without_safety, "time_step": 1e20}},
             "/analysis/time_step", ["found 0.1 s", "expected at most "], False),
            ("a time step of too many", {**DYNAMICS, "analysis": {**without_safety, "time_step": 1e-12}},
             "/analysis/time_step", ["1e+11 steps", "at most 1e+09"], False),
            ("the column without gravity", without_gravity, "/exact/type", ['expected "gravity"'], False),
            ("the column under sideways gravity", {**DYNAMICS, "gravity": [1, -9.81]}, "/exact/type",
             ['expected "gravity"', "the first 0"], False),
            ("the column under a field of gravity", {**DYNAMICS, "gravity": [0, "-9.81"]}, "/exact/type",
             ['expected "gravity"', "two numbers"], False),
            ("the column of another law", {**DYNAMICS, "material": {**DYNAMICS["material"], "type": "neo_hookean"}},
             "/material/type", ['found "neo_hookean"', '"linear_large"', "self_weight_column"], False),
            ("an exact solution of load steps", {**DYNAMICS, "exact": {"type": "plate_with_hole", "radius": 1,
                                                                       "far_field_stress": 1}},
             "/exact/type", ['"self_weight_column"'], True),
            ("a band", {**DYNAMICS, "boundaries": [{**base, "condition": {"type": "fixed", "band": 1e-3}}]},
             "/boundaries/0/condition", ['unknown key "band"'], True),
            ("a support off the grid lines",
             {**DYNAMICS, "grid": {**DYNAMICS["grid"], "lower": [-1.1, -1.1]}}, "/boundaries",
             ['"base"', "leaves the grid lines"], False),
            ("a fill without an outline", unbounded, "/material_points", ["outline"], False),
            ("a point outside the grid", {**unbounded, "material_points": {**listed, "points": [[0.5, 0.5], [9, 9]]}},
             "/material_points", ["point 1 at (9, 9)", "outside the grid"], False),
            *[(f"dynamics with {key}", {**DYNAMICS, key: CASE[key]}, f"/{key}", ["expected none", '"explicit_dynamics"'],
               True) for key in ("tracking", "samples")],
            ("dynamics with a condition estimate", {**DYNAMICS, "diagnostics": {"condition_estimate": True}},
             "/diagnostics", ['unknown key "condition_estimate"'], True),
            ("a probe at a place in dynamics", {**DYNAMICS, "probes": [{**DYNAMICS["probes"][0], "at": "place"}]},
             "/probes/0", ['unknown key "at"'], True),
            ("a ghost mass beside a lumped mass", {**DYNAMICS, "ghost": 1e-3}, "/ghost", ["lumping erases", "consistent"],
             False),
            *[(f"dynamics with analysis.{key}", {**DYNAMICS, "analysis": {**DYNAMICS["analysis"], key: value}},
               "/analysis", [f'unknown key "{key}"'], True)
              for key, value in (("load_steps", 2), ("load", "t"), ("loading", "residual"))],
            *[(f"load steps with {key}", {**CASE, key: DYNAMICS[key]}, f"/{key}", ["expected none", '"quasi_static"'],
               True) for key in ("initial_velocity", "history")]]:
        yield Wrong(name, json.dumps(case), pointer, words, structural)
    whole = json.dumps(DYNAMICS)
    for number in ("NaN", "Infinity"):
        yield Wrong(f"a time step of {number}", whole.replace('"auto"', number, 1), "", ["line 1, column"], False)
    yield Wrong("a time step of 1e999", whole.replace('"auto"', "1e999", 1), "/analysis/time_step", ["double"], False)
