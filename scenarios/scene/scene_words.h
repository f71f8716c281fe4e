#pragma once

#include "scenarios/scenario.h"
#include "scenarios/scene/json_reader.h"
#include "scenarios/scene/scene.h"

/// What reading and writing scene files have in common.
namespace plumb::scene_words {

constexpr int format = 1;  // of scene files; grows when a reader of the old one would be misled

constexpr Word<BodyType> body_types[] = {
    {"static", BodyType::fixed}, {"kinematic", BodyType::kinematic}, {"dynamic", BodyType::dynamic}};

constexpr Word<FrictionMixing> friction_rules[] = {{"geometric", FrictionMixing::geometric},
                                                   {"pythagorean", FrictionMixing::pythagorean},
                                                   {"average", FrictionMixing::average},
                                                   {"min", FrictionMixing::min},
                                                   {"max", FrictionMixing::max},
                                                   {"multiply", FrictionMixing::multiply}};

constexpr Word<RestitutionMixing> restitution_rules[] = {{"max", RestitutionMixing::max},
                                                         {"min", RestitutionMixing::min},
                                                         {"average", RestitutionMixing::average},
                                                         {"multiply", RestitutionMixing::multiply}};

// What a moment can be asked; an apex belongs to a whole flight.
inline const Word<Quantity> quantities[] = {{name_of(Quantity::x), Quantity::x},
                                            {name_of(Quantity::y), Quantity::y},
                                            {name_of(Quantity::angle), Quantity::angle},
                                            {name_of(Quantity::vx), Quantity::vx},
                                            {name_of(Quantity::vy), Quantity::vy},
                                            {name_of(Quantity::speed), Quantity::speed},
                                            {name_of(Quantity::angular_velocity), Quantity::angular_velocity},
                                            {name_of(Quantity::energy), Quantity::energy},
                                            {name_of(Quantity::momentum_x), Quantity::momentum_x},
                                            {name_of(Quantity::momentum_y), Quantity::momentum_y},
                                            {name_of(Quantity::angular_momentum), Quantity::angular_momentum}};

template <class T, std::size_t n>
const char* word_for(const Word<T> (&words)[n], T value) {
  for (const Word<T>& word : words) {
    if (word.value == value) return word.word;
  }
  return "";
}

/// Whether a quantity is one of the whole scene, not of a body.
constexpr bool of_whole_scene(Quantity quantity) {
  return quantity == Quantity::energy || quantity == Quantity::momentum_x || quantity == Quantity::momentum_y ||
         quantity == Quantity::angular_momentum;
}

}  // namespace plumb::scene_words
