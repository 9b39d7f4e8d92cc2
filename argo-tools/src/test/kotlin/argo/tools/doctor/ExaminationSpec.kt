package argo.tools.doctor

import argo.tools.argo
import argo.tools.board.ProbedBoard
import argo.tools.doctor.Finding.Level
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonArray
import picocli.CommandLine
import java.io.PrintWriter
import java.io.Writer

class ExaminationSpec : FunSpec({
    val board = Device("ttyACM0", isUsb = true, remedy = null, holders = emptyList())
    val healthy = Patient(groups = listOf("ada", "dialout"), devices = Result.success(listOf(board)))

    test("a healthy machine needs no remedies") {
        Examination(healthy).findings().filter { it.level != Level.GOOD || it.remedy != null }.shouldBeEmpty()
    }

    fun with(vararg devices: Device) = healthy.copy(devices = Result.success(devices.asList()))
    fun inNoGroup(vararg devices: Device) = with(*devices).copy(groups = listOf("ada"))
    val brokenDriver = healthy.copy(devices = Result.failure(Exception("no library")))
    val held = board.copy(holders = listOf("process 7 (minicom)"))

    listOf(
        Triple("a Java that is too old", healthy.copy(java = 11), Level.PROBLEM to "ARGO needs 17 or newer"),
        Triple("a driver that does not run", brokenDriver, Level.PROBLEM to "see the message"),
        Triple("no port at all", with(), Level.WARNING to "plug the board in"),
        Triple("only ports of the machine's own", with(board.copy(isUsb = false)), Level.WARNING to "plug the board in"),
        Triple("a board that the user may not open", with(board.copy(remedy = "join them")), Level.PROBLEM to "join them"),
        Triple("a user in no group for ports", inNoGroup(board.copy(remedy = "x")), Level.PROBLEM to "usermod -aG dialout"),
        Triple("such a user before the board is plugged in", inNoGroup(), Level.PROBLEM to "usermod -aG dialout"),
        Triple("a board that another program holds", with(held), Level.PROBLEM to "end that program"),
        Triple("ModemManager", healthy.copy(processes = setOf("ModemManager")), Level.WARNING to "systemctl disable --now ModemManager"),
        Triple("brltty", healthy.copy(processes = setOf("brltty")), Level.WARNING to "apt remove brltty"),
        Triple("no socat", healthy.copy(hasSocat = false), Level.WARNING to "apt install socat"),
        Triple("no socat on a Mac", healthy.copy(hasSocat = false, system = "Mac OS X"), Level.WARNING to "brew install socat"),
    ).forEach { (what, machine, expected) ->
        test("$what is found, with what to do") {
            val (level, remedy) = expected
            Examination(machine).findings().find { it.level == level && remedy in it.remedy.orEmpty() }.shouldNotBeNull()
        }
    }

    test("boards are asked only if that is wanted, and only at free ports on USB") {
        val busy = board.copy(name = "ttyACM1", holders = listOf("process 7 (minicom)"))
        val machine = with(board, busy, board.copy(name = "ttyS0", isUsb = false))
        val asked = ArrayList<String>()
        fun findings(answer: ProbedBoard) = Examination(machine).findings { name -> asked += name; answer }
        findings(ProbedBoard("a Javino board of version 2", answers = true)).find { it.what == "ttyACM0: a Javino board of version 2" }
            .shouldNotBeNull().level shouldBe Level.GOOD
        val silent = findings(ProbedBoard("no answer at 9600 baud", answers = false)).find { it.what == "ttyACM0: no answer at 9600 baud" }
        silent.shouldNotBeNull().level shouldBe Level.PROBLEM
        silent.remedy.orEmpty() shouldContain "upload a sketch that uses the Javino library"
        asked shouldBe listOf("ttyACM0", "ttyACM0")
        Examination(machine).findings().size shouldBe findings(ProbedBoard("", true)).size - 1
    }

    test("Windows has no groups, ModemManager and socat") {
        val windows = healthy.copy(system = "Windows 11", groups = null, processes = setOf("ModemManager"), hasSocat = false)
        Examination(windows).findings().filter { it.level != Level.GOOD }.shouldBeEmpty()
    }

    test("the exit status is 1 for a problem, and 0 with warnings alone") {
        fun status(machine: Machine) = CommandLine(DoctorCommand(machine)).setOut(PrintWriter(Writer.nullWriter())).execute()
        status(healthy) shouldBe 0
        status(healthy.copy(hasSocat = false)) shouldBe 0
        status(inNoGroup(board.copy(isUsb = false, remedy = "x"))) shouldBe 1
    }

    test("the command examines this machine, and opens no port") {
        val said = argo("doctor", "--json")
        Json.parseToJsonElement(said.out).jsonArray.first().toString() shouldContain "Java is ${Runtime.version()}"
        argo("doctor").out shouldContain "ok      Java is"
    }
})

private data class Patient(
    override val system: String = "Linux",
    override val java: Int = 21,
    override val javaInFull: String = "some Java",
    override val user: String = "ada",
    override val groups: List<String>?,
    override val processes: Set<String> = emptySet(),
    override val hasSocat: Boolean = true,
    val devices: Result<List<Device>>,
) : Machine {
    override fun ports() = devices
}
