plugins { `java-library` }

dependencies {
    compileOnly(libs.jason) // the user's project brings Jason
    api(project(":argo-arch"))
    implementation(libs.serialization.json) // what a bridge is sent and sends
    testImplementation(libs.jason)
    testImplementation(libs.java.websocket) // the tests' own bridge
}
