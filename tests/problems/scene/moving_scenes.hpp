#pragma once
// One mass before a stop, and what a scene says of its load and its motion.

#include <string>

#include "problems/scene/scene_file.hpp"

namespace signorini::test {

/// An oscillator under a load of 2 rad/s, with more text after its [forcing] table, from line 10 on.
inline std::string oscillator_with(const std::string& text) {
  return R"(schema = 1
name = "own"
[system]
kind = "sdof"
mass = 2.0
damping = 0.1
stiffness = 3.0
[forcing]
frequency = 2.0
)" + text;
}

/// What refuses it, "" if nothing.
inline std::string refusal_of(const std::string& text) {
  try {
    (void)parse_scene(oscillator_with(text), "scene.toml");
    return "";
  } catch (const SceneError& error) {
    return error.what();
  }
}

}  // namespace signorini::test
