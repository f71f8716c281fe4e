#include "methods/article.h"

#include "core/method_list.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

const MethodList<Solver>::Entry article_entry{
    {"article", "impulses without accumulation, then linear position correction",
     "R. Gaul, How to create a custom 2D physics engine (the seed), with its demo engine"},
    [] { return std::make_unique<Article<ArticleFormulas>>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
