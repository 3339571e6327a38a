#pragma once
// Damping models as scene files give them.

#include "problems/assembly/damping.hpp"
#include "problems/scene/scene_field.hpp"

namespace signorini {

/// One ratio, or a list of them, for a system of `size` coordinates. \throws SceneError
ModalDamping read_modal(const SceneField& modal, int size);

/// alpha and beta of a table, 0 where absent. \throws SceneError
RayleighDamping read_rayleigh(const SceneField& rayleigh);

/// { alpha = .., beta = .. } or { modal = .. } for a system of `size` coordinates. \throws SceneError
DampingModel read_damping(const SceneField& damping, int size);

}  // namespace signorini
