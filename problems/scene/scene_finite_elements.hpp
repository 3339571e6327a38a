#pragma once
// The kinds of [system] that are finite-element structures.

#include "problems/scene/scene_field.hpp"
#include "problems/scene/system_description.hpp"

namespace signorini {

// Each reads the table of its kind. \throws SceneError for anything but a sound one

SystemDescription read_bar(const SceneField& system);
SystemDescription read_beam(const SceneField& system);
SystemDescription read_block(const SceneField& system);
SystemDescription read_shaft(const SceneField& system);

}  // namespace signorini
