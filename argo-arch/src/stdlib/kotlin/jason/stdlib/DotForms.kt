@file:Suppress("ClassName")

package jason.stdlib

/** `.port(…)`: see [argo.port]. */
class port : argo.port()

/** `.limit(…)`: see [argo.limit]. */
class limit : argo.limit()

/** `.percepts(…)`: see [argo.percepts]. */
class percepts : argo.percepts()

/** `.act(…)`: see [argo.act]. */
class act : argo.act()

/** `.change_filter(…)`: see [argo.change_filter]. */
class change_filter : argo.change_filter()

/** `.filter(…)`: see [argo.change_filter]. */
class filter : argo.change_filter()

/** `.explain(…)`: see [argo.explain]. */
class explain : argo.explain()

/** `.age(…)`: see [argo.age]. */
class age : argo.age()

/** `.can(…)`: see [argo.can]. */
class can : argo.can()

/** `.ports(…)`: see [argo.ports]. */
class ports : argo.ports()

/** `.skew(…)`: see [argo.skew]. */
class skew : argo.skew()

/** `.record(…)`: see [argo.record]. */
class record : argo.record()

/** `.reload(…)`: see [argo.reload]. */
class reload : argo.reload()
