// The steps against closed forms.
#include "techniques/sh_ambient/ringing.h"
#include "techniques/sh_ambient/sh_ambient.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luch::techniques::sh_ambient {
namespace {
const Steps steps = reference();
}  // namespace
}  // namespace luch::techniques::sh_ambient
