"""Links the archive that fits the board's processor core."""
from os.path import join, realpath

Import("env")  # noqa: F821
flags = DefaultEnvironment().Flatten(DefaultEnvironment().get("CCFLAGS", []))  # noqa: F821
core = DefaultEnvironment().BoardConfig().get("build.cpu", "")  # noqa: F821
if core in ("cortex-m4", "cortex-m7", "cortex-m33"):
    core += "-hard" if "-mfloat-abi=hard" in flags else "-soft"
# a Cortex-M7 with the soft float ABI runs the code of a Cortex-M4
core = {"cortex-m0": "cortex-m0plus", "cortex-m7-soft": "cortex-m4-soft", "": "rv32imac"}.get(core, core)
env.Append(LIBPATH=[realpath(join("lib", core))], LIBS=["toytop"])  # noqa: F821
