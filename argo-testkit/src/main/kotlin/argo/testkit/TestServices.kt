package argo.testkit

import jason.JasonException
import jason.asSemantics.Agent
import jason.mas2j.ClassParameters
import jason.runtime.RuntimeServices
import jason.runtime.RuntimeServicesFactory
import java.lang.reflect.InvocationHandler
import java.lang.reflect.InvocationTargetException
import java.lang.reflect.Method
import java.lang.reflect.Proxy
import java.rmi.RemoteException

/**
 * The runtime services of Jason's internal actions, such as `.create_agent` and `.stopMAS`. A call by an agent under test goes to its
 * [TestMas]. Calls of other agents go to the real multi-agent system. Calls are dispatched by name, since Jason's versions name some
 * services differently.
 */
internal class TestServices private constructor(private val real: RuntimeServices?) : InvocationHandler {
    override fun invoke(proxy: Any, method: Method, arguments: Array<out Any?>?): Any? {
        val mas = VirtualTime.active()?.mas
        return if (mas != null) serve(mas, method.name, arguments.orEmpty()) else delegate(method, arguments.orEmpty())
    }

    private fun delegate(method: Method, arguments: Array<out Any?>): Any? {
        if (real == null) {
            if (method.name == "isRunning") return false // a real agent asks this before its start
            throw RemoteException("no multi-agent system is running here")
        }
        try {
            return method.invoke(real, *arguments)
        } catch (failed: InvocationTargetException) {
            throw failed.targetException
        }
    }

    private fun serve(mas: TestMas, service: String, with: Array<out Any?>): Any? = when (service) {
        "createAgent" -> createAgent(mas, with)
        "startAgent" -> Unit.let { null } // an agent of a test runs from its creation on
        "killAgent" -> killAgent(mas, with[0] as String, with[1] as String, with[2] as Int)
        "stopMAS" -> mas.stop(mas.running(), with.getOrElse(0) { 0 } as Int).let { null }
        "getNewAgentName" -> mas.newName(with[0] as String)
        "getAgentsNames", "getAgentsName" -> mas.names
        "getAgentsQty" -> mas.names.size
        "getMASName" -> "test"
        "isRunning" -> mas.names.isNotEmpty()
        else -> throw RemoteException("agents under test have no $service, which needs a real run")
    }

    private fun killAgent(mas: TestMas, name: String, by: String, deadlineMs: Int): Boolean {
        val agent = mas.find(name)?.takeIf { it.ts.ag.killAcc(by) } ?: return false
        mas.stop(listOf(agent), deadlineMs)
        return true
    }

    private fun createAgent(mas: TestMas, with: Array<out Any?>): String {
        val source = with[1] as String?
        val father = (with[6] as Agent?)?.ts?.agArch?.agName?.let(mas::find)
        val wanted = AgentSetUp(mas.time, mas.newName(with[0] as String))
        try {
            (with[2] as String?)?.let { wanted.agentClass = Class.forName(it).asSubclass(Agent::class.java) }
            wanted.arch = archOf((with[3] as List<*>?).orEmpty().map { "$it" }, father)
            wanted.beliefBase = with[4] as ClassParameters?
            wanted.environment = father?.setUp?.environment
            wanted.sourcePath(*father?.sourceDirectories.orEmpty().toTypedArray())
            val file = source?.let { found(it, wanted.sourcePaths) }
            mas.make(file, "$file", wanted)
        } catch (refused: IllegalArgumentException) {
            throw JasonException(refused.message, refused)
        } catch (unknown: ClassNotFoundException) {
            throw JasonException("there is no class ${unknown.message}", unknown)
        } catch (other: ClassCastException) {
            throw JasonException("the class of an agent is a subclass of ${Agent::class.java.name}", other)
        }
        return wanted.name
    }

    companion object {
        @Synchronized
        fun install() {
            val there: RuntimeServices? = RuntimeServicesFactory.get()
            if (there != null && Proxy.isProxyClass(there.javaClass) && Proxy.getInvocationHandler(there) is TestServices) return
            val services = RuntimeServices::class.java
            val proxy = Proxy.newProxyInstance(TestServices::class.java.classLoader, arrayOf(services), TestServices(there))
            RuntimeServicesFactory.set(services.cast(proxy))
        }
    }
}
