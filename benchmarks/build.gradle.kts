plugins { application }

application {
    mainClass = "benchmarks.MainKt"
    applicationDefaultJvmArgs = listOf("--enable-native-access=ALL-UNNAMED") // since jSerialComm loads a native library
}
