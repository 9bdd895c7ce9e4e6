#include "framework/apps/verbs.h"

int main(int argc, char** argv) {
    std::vector<std::unique_ptr<luch::Verb>> verbs;
    verbs.push_back(luch::make_list());
    verbs.push_back(luch::make_render());
    verbs.push_back(luch::make_compare());
    verbs.push_back(luch::make_plan());
    verbs.push_back(luch::make_lab());
    verbs.push_back(luch::make_stress());
    verbs.push_back(luch::make_view());
    verbs.push_back(luch::make_bench());
    verbs.push_back(luch::make_check());
    verbs.push_back(luch::make_kit());
    verbs.push_back(luch::make_doctor());
    return luch::dispatch(argc, argv, verbs);
}
