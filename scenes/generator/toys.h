#pragma once

#include "scenes/generator/model.h"

namespace luch::assets {

/// A windmill of stone with wooden sails: tower → cap → axle → four sails, each turned from the
/// last.
Model toy_windmill();

/// A locomotive and two wagons: train → vehicle → axle → wheels, of one wheel.
Model toy_train();

}  // namespace luch::assets
