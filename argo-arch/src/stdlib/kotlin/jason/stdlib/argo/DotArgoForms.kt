@file:Suppress("ClassName")

package jason.stdlib.argo

// The forms `.argo.port(…)` of the internal actions `argo.port(…)`: Jason looks for their classes in this package.

class port : argo.port()
class limit : argo.limit()
class percepts : argo.percepts()
class act : argo.act()
class change_filter : argo.change_filter()
class filter : argo.change_filter()
class explain : argo.explain()
class age : argo.age()
class can : argo.can()
class ports : argo.ports()
class skew : argo.skew()
class record : argo.record()
class reload : argo.reload()
