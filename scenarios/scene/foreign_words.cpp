#include "scenarios/scene/foreign_words.h"

#include <algorithm>
#include <vector>

namespace plumb {
namespace {

struct Feature {
  std::vector<std::string_view> words;  // small letters only
  const char* why;
};

constexpr const char* changing_force =
    "forces that change with time are not in the format; a spring to a kinematic body with a \"path\" pulls in its "
    "rhythm, and a body may have a \"velocity\" at the start";

// Features of Box2D, Chipmunk, Rapier and matter.js, by the words of their formats.
const std::vector<Feature>& features() {
  static const std::vector<Feature> all{
      {{"motor", "enablemotor", "motorspeed", "maxmotortorque", "maxmotorforce", "simplemotor", "motorjoint"},
       "write \"motor\": { \"speed\": .., \"strength\": .. } in a revolute joint, in rad/s and N m, or in a prismatic "
       "one, in m/s and N"},
      {{"lowerangle", "upperangle", "enablelimit", "rotarylimit", "rotarylimitjoint"},
       "write \"limits\": [lower, upper] in a revolute joint, in rad"},
      {{"lowertranslation", "uppertranslation", "groovejoint"},
       "write \"limits\": [lower, upper] in a prismatic joint, in m"},
      {{"minlength", "maxlength", "slidejoint", "rope", "ropejoint"},
       "limits of distance joints (ropes) are not in the format: one keeps its \"length\", or yields with a "
       "\"stiffness\""},
      {{"wheel", "wheeljoint"}, "wheel joints are not in the format; a revolute joint and a spring come close"},
      {{"mouse", "mousejoint", "target"},
       "mouse joints are not in the format; a spring to a point of the world pulls like one"},
      {{"pulley", "gear", "ratchet", "frictionjoint", "filterjoint", "gearjoint", "pulleyjoint"},
       "joints of this kind are not in the format"},
      {{"enablespring", "hertz", "frequencyhz", "dampingratio", "springhertz", "linearhertz", "angularhertz"},
       "springs have a \"stiffness\" in N/m and a \"damping\" in N s/m: k = m (2 pi f)^2, c = 4 pi m f zeta"},
      {{"localanchora", "localanchorb", "anchora", "anchorb", "pointa", "pointb", "referenceangle"},
       "anchors are points of the world at the start: \"anchor\", or \"anchors\" of a distance joint"},
      {{"collideconnected"}, "bodies that a joint connects never collide with each other; the format has no exception"},
      {{"chain", "chainshape", "edge", "edgeshape", "loop", "isloop"},
       "chains are not in the format; write a segment for each edge"},
      {{"sensor", "issensor", "sensors"}, "sensors are not in the format: nothing is asked of them"},
      {{"categorybits", "maskbits", "category", "mask", "filter", "collisionfilter", "collisiongroups"},
       "write \"layers\" in a body: two bodies collide if their layers share a bit. Separate categories and masks are "
       "not in the format"},
      {{"groupindex", "group"}, "collision groups are not in the format; write \"layers\" in a body"},
      {{"rollingresistance", "rollingfriction", "torsionalfriction", "frictionair", "frictionstatic"},
       "rolling resistance and other frictions are not in the format; \"friction\" is Coulomb's, and bodies have "
       "\"linearDamping\" and \"angularDamping\""},
      {{"tangentspeed", "tangentialspeed", "surfacevelocity", "surfacespeed", "beltspeed"},
       "surface speeds are not in the format; a kinematic body that moves is a belt"},
      {{"restitutionthreshold", "velocitythreshold"},
       "restitution thresholds are not in the format: restitution acts at any speed, and engines state their own"},
      {{"path", "keyframes", "waypoints", "trajectory"},
       "write \"path\": { \"type\": \"sinusoidal\", \"amplitude\": [x, y], \"frequency\": .. } in a kinematic body; "
       "other paths are not in the format"},
      {{"impulse", "linearimpulse", "angularimpulse", "schedule", "starttime", "endtime", "until", "pulse", "periodic",
        "sinusoidal"},
       changing_force},
      {{"linearvelocity"}, "write \"velocity\""},
      {{"isbullet", "ccd", "ccdenabled"}, "write \"bullet\""},
      {{"mass", "inertia", "centerofmass", "rotationalinertia"},
       "mass and inertia follow from the shapes and their \"density\", kg/m^2"},
      {{"awake", "allowsleep", "enablesleep", "sleepthreshold", "issleeping", "isawake"},
       "sleeping is a matter of the engine, not of the scene: see plumb help impulse"}};
  return all;
}

}  // namespace

std::string foreign_word(std::string_view word) {
  std::string plain;
  for (const char letter : word) {
    if (letter == '-' || letter == '_') continue;
    plain += letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  }
  for (const Feature& feature : features()) {
    if (std::ranges::find(feature.words, plain) != feature.words.end()) return feature.why;
  }
  return "";
}

}  // namespace plumb
